#!/bin/sh
# libGDX's Intersector.intersectRayBounds says whether a ray meets a box, and where. The ray from (-3, -3, 0)
# along (1, 1, 0) goes through the middle of the box [-1, 1]^3, on a length of 2.8; the answer is false. The
# ray enters at an edge of the box: the entry into each of its two faces is computed, rounded to float, and
# found to lie just outside of the other. Of all rays between the integers of [-3, 3]^3 that cross the
# interior of the box, 36 of 5,880 are said to miss it; intersectRayBoundsFast, beside it, finds all.
#
# Judged in integers (times in sixths; a direction's components are at most 3).
set -eu
d=$(mktemp -d)
trap 'rm -rf "$d"' EXIT
cd "$d"
cat > pom.xml <<'POM'
<project xmlns="http://maven.apache.org/POM/4.0.0">
  <modelVersion>4.0.0</modelVersion>
  <groupId>try</groupId><artifactId>try</artifactId><version>0</version>
  <dependencies>
    <dependency><groupId>com.badlogicgames.gdx</groupId><artifactId>gdx</artifactId><version>1.13.1</version></dependency>
  </dependencies>
</project>
POM
mvn -q dependency:copy-dependencies -DoutputDirectory=lib > mvn.log
cat > Try.java <<'JAVA'
import com.badlogic.gdx.Version;
import com.badlogic.gdx.math.*;
import com.badlogic.gdx.math.collision.*;

class Try {
    static final BoundingBox BOX = new BoundingBox(new Vector3(-1, -1, -1), new Vector3(1, 1, 1));

    /** Whether the ray meets the interior of the box: o + t d for a t >= 0, in sixths. */
    static boolean crosses(int[] o, int[] d) {
        int enter = 0, leave = Integer.MAX_VALUE;
        for (int a = 0; a < 3; a++) {
            if (d[a] == 0) {
                if (Math.abs(o[a]) >= 1) return false;
                continue;
            }
            int near = (-1 - o[a]) * 6 / d[a], far = (1 - o[a]) * 6 / d[a]; // exact
            enter = Math.max(enter, Math.min(near, far));
            leave = Math.min(leave, Math.max(near, far));
        }
        return enter < leave;
    }

    public static void main(String[] unused) {
        System.out.println("libGDX " + Version.VERSION);
        Ray ray = new Ray(new Vector3(-3, -3, 0), new Vector3(1, 1, 0));
        boolean one = Intersector.intersectRayBounds(ray, BOX, null), fast = Intersector.intersectRayBoundsFast(ray, BOX);
        System.out.println("ray from (-3, -3, 0) along (1, 1, 0), box [-1, 1]^3: intersectRayBounds " + one
                + ", intersectRayBoundsFast " + fast);
        int crossed = 0, missed = 0, missedFast = 0;
        int[] o = new int[3], d = new int[3];
        for (int n = 0; n < 117649; n++) { // 7^6
            for (int a = 0, m = n; a < 6; a++, m /= 7) (a < 3 ? o : d)[a % 3] = m % 7 - 3;
            if ((d[0] | d[1] | d[2]) == 0 || !crosses(o, d)) continue;
            ray = new Ray(new Vector3(o[0], o[1], o[2]), new Vector3(d[0], d[1], d[2]));
            crossed++;
            if (!Intersector.intersectRayBounds(ray, BOX, null)) missed++;
            if (!Intersector.intersectRayBoundsFast(ray, BOX)) missedFast++;
        }
        System.out.println(crossed + " rays cross the interior: intersectRayBounds misses " + missed
                + ", intersectRayBoundsFast " + missedFast);
        if (one || !fast || crossed != 5880 || missed != 36 || missedFast != 0) System.exit(1);
    }
}
JAVA
javac -cp 'lib/*' Try.java
java -cp ".:lib/*" Try
