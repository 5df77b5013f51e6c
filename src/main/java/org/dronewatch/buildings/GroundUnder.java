package org.dronewatch.buildings;

import java.util.HashSet;
import java.util.Set;
import org.dronewatch.geo.Geodesy;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.terrain.TerrainGround;

/** The ground under buildings: the heights of a building are measured from the lowest ground under it. */
final class GroundUnder {
    private final TerrainGround terrain;
    private final Geodesy geodesy;

    GroundUnder(TerrainGround terrain, Geodesy geodesy) {
        this.terrain = terrain;
        this.geodesy = geodesy;
    }

    /**
     * The lowest and the highest ground within an outline and on it, on the earth: at its corners, at those of the
     * terrain inside, and where edges of both cross, since all of the ground is flat in between.
     *
     * @return heights, m; not numbers where there is no ground under any of these points
     */
    double[] range(Footprint footprint) {
        double[] range = {Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
        double[] box = {
            Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY
        };
        for (double[] ring : footprint.rings()) {
            for (int i = 0; i < ring.length; i += 2) {
                include(range, ring[i], ring[i + 1], terrain.heightAt(ring[i], ring[i + 1]));
                box[0] = Math.min(box[0], ring[i]);
                box[1] = Math.max(box[1], ring[i]);
                box[2] = Math.min(box[2], ring[i + 1]);
                box[3] = Math.max(box[3], ring[i + 1]);
            }
        }
        Set<Integer> seen = new HashSet<>();
        terrain.trianglesNear(box[0], box[1], box[2], box[3], triangle -> {
            if (seen.add(triangle)) {
                include(range, footprint, triangle);
            }
        });
        return range[0] <= range[1] ? range : new double[] {Double.NaN, Double.NaN};
    }

    private void include(double[] range, double x, double y, double z) {
        if (!Double.isNaN(z)) {
            double height = geodesy.onEarth(new Position(x, y, z)).height();
            range[0] = Math.min(range[0], height);
            range[1] = Math.max(range[1], height);
        }
    }

    private void include(double[] range, Footprint footprint, int triangle) {
        TriangleMesh mesh = terrain.mesh();
        for (int k = 0; k < 3; k++) {
            double ax = mesh.coordinate(triangle, k, 0);
            double ay = mesh.coordinate(triangle, k, 1);
            double az = mesh.coordinate(triangle, k, 2);
            if (footprint.contains(ax, ay)) {
                include(range, ax, ay, az);
            }
            int next = (k + 1) % 3;
            double bx = mesh.coordinate(triangle, next, 0) - ax;
            double by = mesh.coordinate(triangle, next, 1) - ay;
            double bz = mesh.coordinate(triangle, next, 2) - az;
            for (double[] ring : footprint.rings()) {
                int last = ring.length - 2;
                for (int i = 0; i < ring.length; i += 2) {
                    double sideX = ring[i] - ring[last];
                    double sideY = ring[i + 1] - ring[last + 1];
                    double cross = bx * sideY - by * sideX;
                    double part = ((ring[last] - ax) * sideY - (ring[last + 1] - ay) * sideX) / cross;
                    double alongSide = ((ring[last] - ax) * by - (ring[last + 1] - ay) * bx) / cross;
                    if (part >= 0.0 && part <= 1.0 && alongSide >= 0.0 && alongSide <= 1.0) {
                        include(range, ax + part * bx, ay + part * by, az + part * bz);
                    }
                    last = i;
                }
            }
        }
    }
}
