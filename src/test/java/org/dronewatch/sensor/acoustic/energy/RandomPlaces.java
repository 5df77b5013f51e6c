package org.dronewatch.sensor.acoustic.energy;

import java.util.SplittableRandom;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.RayTracer;

/** Random places in a site, in the air or just off a surface, like a landed drone and a microphone on a wall. */
final class RandomPlaces {
    /** How far off the ground a landed drone sounds, and off the wall a microphone is mounted, m. */
    private static final double LANDED = 0.1;

    /** A site whose box begins beyond this has surroundings, m. */
    private static final double SURROUNDINGS = -10;

    /** The sites, and the box in each in which places are drawn. */
    enum Where {
        HILL(-40, -40, 125, 40, 40, 160),
        CANYON(-60, -40, 0, 60, 40, 25),
        SEALED(0, 0, 0, 10, 8, 4),
        CHURCH(-8, -20, 0, 8, 20, 12),
        ROOM(0, 0, 0, 10, 8, 4),
        WAVES(-80, -80, -2, 80, 80, 20);

        private final double[] box;

        Where(double... box) {
            this.box = box;
        }

        /** The site, which is read anew each time. */
        SoundSites site() {
            return switch (this) {
                case HILL -> SoundSites.hill();
                case CANYON -> SoundSites.canyon();
                case SEALED -> SoundSites.sealed();
                case CHURCH -> SoundSites.church();
                case ROOM -> SoundSites.room();
                case WAVES -> SoundSites.waves();
            };
        }
    }

    private final Where where;
    private final SoundSites site;
    private final RayTracer tracer;
    private final SplittableRandom random;

    RandomPlaces(Where where, SoundSites site, SplittableRandom random) {
        this.where = where;
        this.site = site;
        this.tracer = site.world().newRayTracer();
        this.random = random;
    }

    /** A place in the air, or just off the surface below or beside it. */
    Position next(boolean isOnSurface) {
        while (true) {
            double[] at = new double[3];
            for (int axis = 0; axis < 3; axis++) {
                at[axis] = random.nextDouble(where.box[axis], where.box[axis + 3]);
            }
            Position place = new Position(at[0], at[1], at[2]);
            boolean hasSurroundings = where.box[0] < SURROUNDINGS;
            if (hasSurroundings && site.world().isInsideWall(place) || isUnderGround(at)) {
                continue;
            }
            if (!isOnSurface) {
                return place;
            }
            double azimuth = random.nextDouble(2 * Math.PI);
            double[] to = random.nextBoolean()
                    ? new double[] {0, 0, -1}
                    : new double[] {Math.cos(azimuth), Math.sin(azimuth), 0};
            if (tracer.closestHit(at[0], at[1], at[2], to[0], to[1], to[2], 0, 100) && tracer.distance() > LANDED) {
                double fly = tracer.distance() - LANDED;
                return new Position(at[0] + fly * to[0], at[1] + fly * to[1], at[2] + fly * to[2]);
            }
        }
    }

    private boolean isUnderGround(double[] at) {
        return !tracer.closestHit(at[0], at[1], at[2], 0, 0, -1, 0, 1000);
    }
}
