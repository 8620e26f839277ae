// The boxes that a segment touches, by rationals, so that nothing may be found, for graze-fuzz to look at:
//
//	go build segments.go && graze-fuzz run --command ./segments
package main

import (
	"encoding/json"
	"fmt"
	"math/big"
	"os"
)

func minus(x, y float64) *big.Rat {
	return new(big.Rat).Sub(new(big.Rat).SetFloat64(x), new(big.Rat).SetFloat64(y))
}

// Whether o + t (e - o) is in the box for a t in [0, 1].
func touches(o, e, lo, hi [3]float64) bool {
	enter, leave := big.NewRat(0, 1), big.NewRat(1, 1)
	for a := range 3 {
		length, near, far := minus(e[a], o[a]), minus(lo[a], o[a]), minus(hi[a], o[a])
		if length.Sign() == 0 && (near.Sign() > 0 || far.Sign() < 0) {
			return false
		}
		if length.Sign() < 0 {
			near, far = far, near
		}
		if length.Sign() != 0 && near.Quo(near, length).Cmp(enter) > 0 {
			enter = near
		}
		if length.Sign() != 0 && far.Quo(far, length).Cmp(leave) < 0 {
			leave = far
		}
	}
	return enter.Cmp(leave) <= 0
}

func main() {
	fmt.Println(`{"promise":"exactly-touched","cells":"boxes","segments":true}`)
	in, out := json.NewDecoder(os.Stdin), json.NewEncoder(os.Stdout)
	for {
		var r struct {
			Origin, End [3]float64
			Boxes       []struct{ Lo, Hi [3]float64 }
			Echo        []float64
		}
		if in.Decode(&r) != nil {
			return
		}
		visited := []int{}
		for i, b := range r.Boxes {
			if touches(r.Origin, r.End, b.Lo, b.Hi) {
				visited = append(visited, i)
			}
		}
		out.Encode(map[string]any{"visited": visited, "echo": r.Echo}) // a line
	}
}
