// The first occupied voxel of a grid, by a test of each, as it is usually written, for graze-fuzz to look
// at. It reads the plain form in bits, which needs no library.
//
//   javac FirstVoxel.java && graze-fuzz run --command "java -cp . FirstVoxel"
import java.io.*;

class FirstVoxel {
    static String[] words;

    static double number(int i) {
        return Double.longBitsToDouble(Long.parseUnsignedLong(words[i], 16));
    }

    /** Where the ray enters the voxel, or NaN. */
    static double enter(int[] voxel) {
        double enter = 0, leave = Double.POSITIVE_INFINITY;
        for (int a = 0; a < 3; a++) {
            double o = number(9 + a), d = number(12 + a), from = number(15 + a), spacing = number(18 + a);
            double lo = from + voxel[a] * spacing, hi = from + (voxel[a] + 1) * spacing;
            if (words[2].equals("rounded")) { // one rounding
                lo = Math.fma(voxel[a], spacing, from);
                hi = Math.fma(voxel[a] + 1, spacing, from);
            }
            double near = (lo - o) / d, far = (hi - o) / d;
            enter = Math.max(enter, Math.min(near, far));
            leave = Math.min(leave, Math.max(near, far)); // NaN for 0/0, which hits nothing
        }
        return enter <= leave ? enter : Double.NaN;
    }

    static String answer() { // id "grid" rule base extent origin direction, and the grid's origin spacing count
        if (!words[2].equals("multiplied") && !words[2].equals("rounded")) return "skip";
        double best = Double.POSITIVE_INFINITY;
        String first = "none";
        int[] base = new int[3], extent = new int[3];
        for (int a = 0; a < 3; a++) {
            base[a] = Integer.parseInt(words[3 + a]);
            extent[a] = Integer.parseInt(words[6 + a]);
        }
        for (int i = 0; i < extent[0] * extent[1] * extent[2]; i++) {
            int[] v = {base[0] + i % extent[0], base[1] + i / extent[0] % extent[1], base[2] + i / extent[0] / extent[1]};
            double t = enter(v);
            if (t < best) {
                best = t;
                first = String.format("%d %d %d t %016x", v[0], v[1], v[2], Double.doubleToRawLongBits(t));
            }
        }
        return first;
    }

    public static void main(String[] unused) throws IOException {
        var in = new BufferedReader(new InputStreamReader(System.in));
        System.out.println("promise first cells grid numbers bits");
        for (String line; (line = in.readLine()) != null; ) {
            words = line.split(" ");
            System.out.println(answer()); // println flushes
        }
    }
}
