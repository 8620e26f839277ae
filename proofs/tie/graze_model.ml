(* The extracted model as a program: reads lines of numbers, answers what the ray/octant test of
   octree/ must answer, bit for bit. README.md describes the lines. Model is made by
   proofs/coq/Extraction.v; here is only reading and writing. *)

module Integer = Z (* Zarith's; the model has a Z of its own *)
open Model

let prec = Integer.of_int 53
let emax = Integer.of_int 1024
let fail line reason = Printf.eprintf "graze-model: %s: %s\n" reason line; exit 2

(* A number is a hex float (0x1.8p-3) or the 16 digits of its pattern, zeros at the end left out. *)
let pattern token =
  if String.contains token 'x' then Int64.bits_of_float (float_of_string token)
  else Int64.of_string ("0x" ^ token ^ String.make (16 - String.length token) '0')

let shortened p =
  let digits = Printf.sprintf "%016Lx" p in
  let rec length n = if n > 1 && digits.[n - 1] = '0' then length (n - 1) else n in
  String.sub digits 0 (length 16)

let two_64 = Integer.shift_left Integer.one 64
let of_pattern p =
  let z = Integer.of_int64 p in
  number_of_bits (if Integer.sign z < 0 then Integer.add z two_64 else z)
let to_pattern x =
  let z = bits_of_number x in
  Integer.to_int64 (if Integer.geq z (Integer.shift_left Integer.one 63) then Integer.sub z two_64 else z)

(* Answers: named numbers, folded to 64 bits in the order in which they are named. *)
type answers = { mutable fold : int64; mutable verdicts : string list; show : bool }

let start = 0xcbf29ce484222325L
let fold h word =
  let h = Int64.mul (Int64.logxor h word) 0x100000001b3L in
  Int64.logxor h (Int64.shift_right_logical h 32)

let number a name x =
  let p = to_pattern x in
  if a.show then Printf.printf "  %s %016Lx\n" name p;
  a.fold <- fold a.fold p

let verdict a name text =
  if a.show then Printf.printf "  %s %s\n" name text;
  a.verdicts <- text :: a.verdicts

let bit b = if b then "1" else "0"
let digits list = if list = [] then "-" else String.concat "" (List.map Integer.to_string list)

type line = {
  text : string; (* the question as patterns *)
  o : number three; d : number three; lo : number three; hi : number three; mid : number three;
  edge : number option; tree : bool }

let map f v = { at_x = f v.at_x; at_y = f v.at_y; at_z = f v.at_z }

let negative x = Int64.compare (to_pattern x) 0L < 0

let answer b m show l =
  let cell_plane plane given = match l.edge with
    | None -> given
    | Some size -> map (fun lo -> plane m lo size) l.lo in
  let hi = cell_plane hi_plane l.hi and mid = cell_plane mid_plane l.mid in
  let a = { fold = start; verdicts = []; show } in
  let ray = prepare_ray b l.o l.d in
  let of_axis name axis lo hi mid =
    number a (name ^ ".c_down") axis.c_down;
    number a (name ^ ".c_up") axis.c_up;
    number a (name ^ ".lowb(lo,hi)") (lowb prec emax b axis lo hi);
    number a (name ^ ".uppb(lo,hi)") (uppb prec emax b axis lo hi);
    number a (name ^ ".lowb(mid,o)") (lowb prec emax b axis mid axis.origin);
    number a (name ^ ".uppb(mid,o)") (uppb prec emax b axis mid axis.origin);
    number a (name ^ ".enter_at(mid)") (enter_at prec emax b axis mid);
    number a (name ^ ".leave_at<closed>(mid)") (leave_at prec emax b Closed axis mid);
    number a (name ^ ".leave_at<owned>(mid)") (leave_at prec emax b Owned axis mid);
    let owned = within prec emax b Owned axis lo hi and closed = within prec emax b Closed axis lo hi in
    number a (name ^ ".within<owned>.enter") owned.enter;
    number a (name ^ ".within<owned>.leave") owned.leave;
    number a (name ^ ".within<closed>.enter") closed.enter;
    number a (name ^ ".within<closed>.leave") closed.leave;
    closed
  in
  let x = of_axis "x" ray.at_x l.lo.at_x hi.at_x mid.at_x in
  let y = of_axis "y" ray.at_y l.lo.at_y hi.at_y mid.at_y in
  let z = of_axis "z" ray.at_z l.lo.at_z hi.at_z mid.at_z in
  let both name p q =
    let c = common prec emax p q in
    number a (name ^ ".enter") c.enter;
    number a (name ^ ".leave") c.leave
  in
  both "common(x,y)" x y;
  both "common(y,x)" y x;
  both "common(y,z)" y z;
  let side axis mid = if origin_side prec emax axis mid then 1 else 0 in
  let sides = side ray.at_x mid.at_x lor side ray.at_y mid.at_y lsl 1
              lor side ray.at_z mid.at_z lsl 2 in
  verdict a "touches" (bit (touches_box prec emax b ray l.lo hi));
  verdict a "passes(x,y)" (bit (passes2 prec emax x y));
  verdict a "origin_side" (string_of_int sides);
  let mask cv =
    let halves axis at_ mid = Array.map (half prec emax b cv axis at_ mid) [| false; true |] in
    let hx = halves ray.at_x x mid.at_x and hy = halves ray.at_y y mid.at_y
    and hz = halves ray.at_z z mid.at_z in
    let m = ref 0 in
    for i = 0 to 7 do
      if passes prec emax hx.(i land 1) hy.(i lsr 1 land 1) hz.(i lsr 2) then m := !m lor (1 lsl i)
    done;
    Printf.sprintf "%02x" !m
  in
  verdict a "children<closed>" (mask Closed);
  verdict a "children<owned>" (mask Owned);
  (match l.edge with
   | None -> ()
   | Some size ->
     let root : cube = { Model.lo = l.lo; size } in
     let state = root_state m b ray root in
     verdict a "entered" (bit (passed prec emax state));
     let order name cv = verdict a name (digits (children m b cv ray root state)) in
     order "split<closed>" Closed;
     order "split<owned>" Owned;
     if l.tree then begin
       (* a tree of three levels that holds every cell but those whose indices sum up to 4 modulo 5 *)
       let kept path = List.fold_left (fun n i -> n + Integer.to_int i) 0 path mod 5 <> 4 in
       let visits name cv =
         let seen = descent m b cv ray kept root (S (S (S O))) in
         let h = List.fold_left (fun h (path, cell) ->
             let h = List.fold_left (fun h i -> fold h (Int64.of_int (Integer.to_int i))) h path in
             List.fold_left (fun h x -> fold h (to_pattern x)) h
               [ cell.Model.lo.at_x; cell.Model.lo.at_y; cell.Model.lo.at_z; cell.Model.size ]) start seen in
         verdict a name (Printf.sprintf "%d/%016Lx" (List.length seen) h)
       in
       visits "descent<closed>" Closed;
       visits "descent<owned>" Owned
     end);
  String.concat " " (List.rev (Printf.sprintf "%016Lx" a.fold :: a.verdicts))

(* The substitutes of Extraction.v for three definitions, against the definitions. *)
let check_substitutes () =
  let state = Random.State.make [| 5 |] in
  let below n = Random.State.int state n in
  let integer bits =
    let rec make n acc =
      if n <= 0 then acc else make (n - 24) (Integer.logor (Integer.shift_left acc 24)
                                               (Integer.of_int (below 0x1000000))) in
    (* long runs of zeros at the end, so that every bit decides at times *)
    Integer.shift_left (Integer.add (make bits Integer.zero) Integer.one) (below 3 * below 70) in
  for _ = 1 to 3000 do
    let m = integer (below 240) and n = Integer.of_int (1 + below 260) in
    let e = Integer.of_int (below 4000 - 2000) in
    let at_odds name = Printf.eprintf "graze-model: %s is not as defined\n" name; exit 2 in
    if not (Integer.equal (digits2_pos m) (digits_as_defined m)) then at_odds "digits2_pos";
    if not (Integer.equal (shift_pos n m) (shift_as_defined n m)) then at_odds "shift_pos";
    let sign = below 5 in
    let m = if sign = 0 then Integer.neg m else if sign = 1 then Integer.zero else m in
    let mrs = { shr_m = m; shr_r = below 2 = 0; shr_s = below 2 = 0 } in
    List.iter (fun n ->
        let (a, x) = shr mrs e n and (b, y) = shr_as_defined mrs e n in
        if not (Integer.equal a.shr_m b.shr_m && a.shr_r = b.shr_r && a.shr_s = b.shr_s
                && Integer.equal x y) then at_odds "shr")
      [ n; Integer.neg n; Integer.zero ]
  done

let parse line =
  let tokens = List.filter (( <> ) "") (String.split_on_char ' ' line) in
  let kind, patterns =
    match tokens with
    | kind :: rest ->
      (* what stands after a colon is an answer *)
      let rec upto = function [] | ":" :: _ -> [] | t :: r -> t :: upto r in
      (kind, List.map pattern (upto rest))
    | [] -> fail line "an empty line"
  in
  let text = String.concat " " (kind :: List.map shortened patterns) in
  let numbers = Array.of_list (List.map of_pattern patterns) in
  let three i = { at_x = numbers.(i); at_y = numbers.(i + 1); at_z = numbers.(i + 2) } in
  match kind, Array.length numbers with
  | "b", 15 -> { text; o = three 0; d = three 3; lo = three 6; hi = three 9; mid = three 12; edge = None;
                 tree = false }
  | ("c" | "t"), 10 ->
    let size = numbers.(9) and lo = three 6 in
    { text; o = three 0; d = three 3; lo; hi = lo; mid = lo; edge = Some size; tree = kind = "t" }
  | _ -> fail line "neither b with 15 numbers nor c or t with 10"

let () =
  check_substitutes ();
  let option name = Array.exists (( = ) name) Sys.argv in
  let show = option "--show" and quick = option "--quick" in
  let count = ref 0 in
  try
    while true do
      let line = input_line stdin in
      incr count;
      if line = "" || line.[0] = '#' then print_endline line
      else begin
        let l = try parse line with Failure _ | Invalid_argument _ -> fail line "not numbers" in
        if show then print_endline line;
        let answered = answer directed_backend Mode_NE show l in
        List.iter (fun (name, b) ->
            if answered <> answer b Mode_NE false l then
              fail line ("the model's backends directed and " ^ name ^ " differ"))
          (("upward", upward_backend)
           (* those of integers take most of the time *)
           :: if quick && !count mod 8 <> 0 then []
              else [ "nearest", nearest_backend;
                     "nearest with a fused operation", nearest_fma_backend ]);
        print_string l.text; print_string " : "; print_string answered;
        (* where it is another: with planes computed in a mode that rounds down, in which a sum of 0
           is -0 *)
        if l.edge <> None && List.exists negative [ l.lo.at_x; l.lo.at_y; l.lo.at_z ] then begin
          let down = answer directed_backend Mode_DN false l in
          if down <> answered then (print_string " ; "; print_string down)
        end;
        print_newline ()
      end
    done
  with End_of_file -> ()
