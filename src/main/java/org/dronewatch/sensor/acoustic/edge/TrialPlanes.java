package org.dronewatch.sensor.acoustic.edge;

import java.util.Arrays;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * The planes through a line in which paths around obstacles are tried: at equal angles to each other and, if the line
 * passes through a surface at a small angle, more of them near that surface: the others then all cut it along almost
 * the same line, and miss its edges to either side. For use by one thread.
 */
final class TrialPlanes {
    /** The number of planes at equal angles. */
    static final int EVEN = 12;

    /** The number of lines, at equal angles to each other, along which more planes cut a surface. */
    private static final int NEAR = 24;

    /** The greatest number of planes: there may be a surface at either end of the line. */
    static final int MOST = EVEN + 2 * (NEAR - 1);

    /** Sine of the angle between line and surface below which there are more planes near the surface. */
    private static final double GRAZING = 0.1;

    private final TriangleMesh mesh;
    private final Visibility visibility;
    private final double[] normal = new double[3];
    private final double[] angles = new double[MOST];
    private int count;

    TrialPlanes(World world) {
        this.mesh = world.mesh();
        this.visibility = Visibility.ofClearPoints(world);
    }

    /** Chooses planes through a line. */
    void choose(StraightLine line) {
        count = 0;
        for (int i = 0; i < EVEN; i++) {
            angles[count++] = i * Math.PI / EVEN;
        }
        Position along = line.to().minus(line.from());
        int triangle = firstHit(line.from(), along);
        addNear(triangle, line);
        int last = firstHit(line.to(), along.times(-1.0));
        if (last != triangle) {
            addNear(last, line);
        }
        Arrays.sort(angles, 0, count);
    }

    /** The first triangle that a line hits, or -1. */
    private int firstHit(Position from, Position along) {
        return visibility.findFirstAlong(from.x(), from.y(), from.z(), along.x(), along.y(), along.z(), 1.0)
                ? visibility.triangle()
                : -1;
    }

    /** Adds planes that cut a surface along lines at equal angles to each other. */
    private void addNear(int triangle, StraightLine line) {
        if (triangle < 0) {
            return;
        }
        mesh.normal(triangle, normal);
        Position across = new Position(normal[0], normal[1], normal[2]).unit();
        double sine = Math.abs(across.dot(line.ahead()));
        if (!(sine < GRAZING)) {
            return;
        }
        // The plane perpendicular to the surface cuts it along the projection of the line.
        double perpendicular = Math.atan2(across.dot(line.across()), across.dot(line.up()));
        for (int i = 1; i < NEAR; i++) {
            // A line at this angle to the projection.
            double inSurface = i * Math.PI / NEAR;
            double angle = perpendicular + Math.atan2(Math.sin(inSurface), sine * Math.cos(inSurface));
            angles[count++] = angle - Math.PI * Math.floor(angle / Math.PI);
        }
    }

    int count() {
        return count;
    }

    /** The angle of a plane, in ascending order, from 0 to pi; see {@link StraightLine#side}. */
    double angle(int plane) {
        return angles[plane];
    }

    /** The angle by which the next plane follows, rad. */
    double step(int plane) {
        return plane + 1 < count ? angles[plane + 1] - angles[plane] : angles[0] + Math.PI - angles[plane];
    }
}
