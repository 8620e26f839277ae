// The first occupied voxel of a grid, by a test of each, as it is usually written, for graze-fuzz to look
// at. It reads the plain form in bits, which needs no library.
//
//   javac FirstVoxel.java && graze-fuzz run --command "java -cp . FirstVoxel"
import java.io.*;

class FirstVoxel {
    static String[] words;

    static double number(int i) { return Double.longBitsToDouble(Long.parseUnsignedLong(words[i], 16)); }
    static String bits(double x) { return String.format(" %016x", Double.doubleToRawLongBits(x)); }
    static int whole(int i) { return Integer.parseInt(words[i]); }

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
            enter = Math.max(enter, Math.min((lo - o) / d, (hi - o) / d)); // NaN for 0/0, which hits nothing
            leave = Math.min(leave, Math.max((lo - o) / d, (hi - o) / d));
        }
        return enter <= leave ? enter : Double.NaN;
    }

    static String answer() { // id "grid" rule base extent origin direction, and the grid's origin spacing count
        if (!words[2].equals("multiplied") && !words[2].equals("rounded")) return "skip";
        double best = Double.POSITIVE_INFINITY;
        String first = "none";
        int nx = whole(6), ny = whole(7), nz = whole(8);
        for (int i = 0; i < nx * ny * nz; i++) {
            int[] v = {whole(3) + i % nx, whole(4) + i / nx % ny, whole(5) + i / nx / ny};
            double t = enter(v);
            if (t < best) {
                best = t;
                first = v[0] + " " + v[1] + " " + v[2] + " t" + bits(t);
            }
        }
        return first;
    }

    public static void main(String[] unused) throws IOException {
        var in = new BufferedReader(new InputStreamReader(System.in));
        System.out.println("promise first cells grid numbers bits echo true");
        for (String line; (line = in.readLine()) != null; ) {
            words = line.split(" ");
            var said = new StringBuilder(answer());
            if (line.contains("echo")) { // 16 doubles to be given back, once
                said.append(" echo");
                for (int i = words.length - 16; i < words.length; i++) said.append(bits(number(i)));
            }
            System.out.println(said); // println flushes
        }
    }
}
