// Libraries of Maven Central, asked by graze-fuzz about boxes: Adapter LIBRARY (run.py builds and runs).
import com.badlogic.gdx.math.Intersector;
import com.badlogic.gdx.math.Vector3;
import com.jme3.bounding.BoundingBox;
import com.jme3.collision.CollisionResults;
import com.jme3.math.Ray;
import com.jme3.math.Vector3f;
import com.jme3.scene.Mesh;
import com.jme3.scene.VertexBuffer;
import java.io.*;
import java.util.ArrayList;
import java.util.function.IntPredicate;
import org.apache.commons.geometry.euclidean.threed.Vector3D;
import org.apache.commons.geometry.euclidean.threed.line.Lines3D;
import org.apache.commons.geometry.euclidean.threed.shape.Parallelepiped;
import org.apache.commons.numbers.core.Precision;
import org.joml.Intersectiond;
import org.joml.Vector2d;

class Adapter {
    static double[] o = new double[3], d = new double[3];
    static double[][] lo, hi;

    static String listed(IntPredicate hit) {
        var text = new StringBuilder();
        for (int i = 0; i < lo.length; i++) if (hit.test(i)) text.append(i).append(' ');
        return text.toString();
    }

    static String received(double[] origin, double[] direction) {
        var text = new StringBuilder(" received");
        for (double[] v : new double[][] {origin, direction})
            for (double x : v) text.append(String.format(" %016x", Double.doubleToRawLongBits(x)));
        return text.toString();
    }

    static boolean anyFlat() {
        for (int i = 0; i < lo.length; i++) for (int a = 0; a < 3; a++) if (lo[i][a] == hi[i][a]) return true;
        return false;
    }

    /** A mesh is met at its surface: what a ray from inside meets first need not be the box that it is in. */
    static boolean startsInside() {
        boolean any = false;
        for (int i = 0; i < lo.length; i++) {
            boolean inside = true;
            for (int a = 0; a < 3; a++) inside &= lo[i][a] <= o[a] && o[a] <= hi[i][a];
            any |= inside;
        }
        return any;
    }

    static String joml() {
        return listed(i -> Intersectiond.intersectRayAab(o[0], o[1], o[2], d[0], d[1], d[2], lo[i][0], lo[i][1],
                lo[i][2], hi[i][0], hi[i][1], hi[i][2], new Vector2d()));
    }

    static Vector3 gdx(double[] v) {
        return new Vector3((float) v[0], (float) v[1], (float) v[2]);
    }

    static String gdx() {
        var ray = new com.badlogic.gdx.math.collision.Ray(gdx(o), gdx(d)); // makes the length 1
        if (ray.direction.isZero()) return "skip";
        return listed(i -> Intersector.intersectRayBounds(ray,
                new com.badlogic.gdx.math.collision.BoundingBox(gdx(lo[i]), gdx(hi[i])), null))
                + received(o, new double[] {ray.direction.x, ray.direction.y, ray.direction.z});
    }

    static Vector3f jme(double[] v) {
        return new Vector3f((float) v[0], (float) v[1], (float) v[2]);
    }

    static Ray jmeRay() {
        return new Ray(jme(o), jme(d).normalize()); // "the direction must be normalized"
    }

    static String receivedBy(Ray ray) {
        return received(o, new double[] {ray.direction.x, ray.direction.y, ray.direction.z});
    }

    static String jmeBox() {
        for (int i = 0; i < lo.length; i++) // it keeps centre and half edges
            for (int a = 0; a < 3; a++) {
                float l = (float) lo[i][a], h = (float) hi[i][a], c = (l + h) / 2, e = h - c;
                if (c - e != l || c + e != h || (double) c - e != l || (double) c + e != h) return "skip";
            }
        var ray = jmeRay();
        return listed(i -> new BoundingBox(jme(lo[i]), jme(hi[i])).intersects(ray)) + receivedBy(ray);
    }

    static final int[] FACES = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6,
        2, 1, 3, 7, 1, 7, 5};

    static String jmeTree() {
        if (anyFlat() || startsInside()) return "skip";
        float[] vertices = new float[24 * lo.length];
        int[] index = new int[36 * lo.length];
        for (int i = 0; i < lo.length; i++) {
            for (int k = 0; k < 24; k++)
                vertices[24 * i + k] = (float) ((k / 3 >> k % 3 & 1) == 0 ? lo[i][k % 3] : hi[i][k % 3]);
            for (int k = 0; k < 36; k++) index[36 * i + k] = 8 * i + FACES[k];
        }
        var mesh = new Mesh();
        mesh.setBuffer(VertexBuffer.Type.Position, 3, vertices);
        mesh.setBuffer(VertexBuffer.Type.Index, 3, index);
        mesh.updateBound();
        mesh.createCollisionData();
        var ray = jmeRay();
        var results = new CollisionResults();
        mesh.collideWith(ray, com.jme3.math.Matrix4f.IDENTITY, mesh.getBound(), results);
        var first = results.getClosestCollision();
        return (first == null ? "none" : "" + first.getTriangleIndex() / 12) + receivedBy(ray);
    }

    static String commons() {
        if (anyFlat()) return "skip";
        double largest = 0; // the precision is absolute
        for (int a = 0; a < 3; a++) {
            largest = Math.max(largest, Math.abs(o[a]));
            for (int i = 0; i < lo.length; i++)
                largest = Math.max(largest, Math.max(Math.abs(lo[i][a]), Math.abs(hi[i][a])));
        }
        var precision = Precision.doubleEquivalenceOfEpsilon(1e-12 * largest);
        try {
            var ray = Lines3D.rayFromPointAndDirection(Vector3D.of(o), Vector3D.of(d).normalize(), precision);
            return listed(i -> Parallelepiped.axisAligned(Vector3D.of(lo[i]), Vector3D.of(hi[i]), precision)
                    .linecastFirst(ray) != null);
        } catch (IllegalArgumentException tooSmall) {
            return "skip";
        }
    }

    static String answer(String library) {
        return switch (library) {
            case "joml" -> joml();
            case "gdx" -> gdx();
            case "jme3-box" -> jmeBox();
            case "jme3-tree" -> jmeTree();
            case "commons-geometry" -> commons();
            default -> throw new IllegalArgumentException("usage: Adapter LIBRARY");
        };
    }

    public static void main(String[] arguments) throws IOException {
        var in = new BufferedReader(new InputStreamReader(System.in));
        String library = arguments[0];
        boolean isFloat = library.equals("gdx") || library.startsWith("jme3");
        System.out.println("promise " + (library.equals("jme3-tree") ? "first" : "crossed")
                + " cells boxes numbers bits echo true" + (isFloat ? " float true" : ""));
        for (String line; (line = in.readLine()) != null; ) {
            String[] words = line.split(" "); // id "boxes" origin direction count lo hi lo hi ... [echo 16]
            var numbers = new ArrayList<Double>();
            boolean echo = words[words.length - 17 >= 0 ? words.length - 17 : 0].equals("echo");
            int boxes = Integer.parseInt(words[8]);
            for (int i = 2; i < words.length; i++)
                if (i != 8 && !words[i].equals("echo"))
                    numbers.add(Double.longBitsToDouble(Long.parseUnsignedLong(words[i], 16)));
            lo = new double[boxes][3];
            hi = new double[boxes][3];
            for (int a = 0; a < 3; a++) {
                o[a] = numbers.get(a);
                d[a] = numbers.get(3 + a);
                for (int i = 0; i < boxes; i++) {
                    lo[i][a] = numbers.get(6 + 6 * i + a);
                    hi[i][a] = numbers.get(9 + 6 * i + a);
                }
            }
            var said = new StringBuilder(answer(library));
            if (echo) {
                said.append(" echo");
                for (double x : numbers.subList(numbers.size() - 16, numbers.size()))
                    said.append(String.format(" %016x", Double.doubleToRawLongBits(x)));
            }
            System.out.println(said);
        }
    }
}
