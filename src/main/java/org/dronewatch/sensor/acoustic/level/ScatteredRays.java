package org.dronewatch.sensor.acoustic.level;

import java.util.random.RandomGenerator;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.Directions;

/**
 * Draws the rays that a surface scatters, uniformly over a hemisphere. It takes the same random numbers whichever rays
 * are wanted. Immutable.
 */
final class ScatteredRays {
    /** Above the rounding of directions. */
    private static final double ROUNDING = 1e-9;

    private static final int NUMBERS_PER_RAY = 2;

    private final Position sensor;
    private final double radius;

    /** Which scattered rays are wanted. */
    enum Wanted {
        /** All of them. */
        ALL,
        /** Those directed at the sensor, and perhaps some others. */
        DIRECTED,
        /** No scattered rays. */
        NONE
    }

    /** Chooses among the scattered rays of a surface. */
    @FunctionalInterface
    interface Choice {
        /**
         * Which ones are wanted.
         *
         * @param branch a ray with their origin, level and order, in any direction
         */
        Wanted of(AcousticRay branch);
    }

    /**
     * Rays that may be directed at a sensor.
     *
     * @param sensor its centre, m
     * @param radius within which rays are directed at it, m
     */
    ScatteredRays(Position sensor, double radius) {
        this.sensor = sensor;
        this.radius = radius;
    }

    /**
     * Draws rays on one side of a surface.
     *
     * @param branch a ray of them, which is reused
     * @param count how many are drawn
     * @param normal unit normal of the surface
     * @param side 1 for the side of the normal, -1 for the other one
     * @param target receives those that are wanted
     */
    void draw(
            AcousticRay branch,
            int count,
            double[] normal,
            double side,
            RandomGenerator random,
            Wanted wanted,
            ReflectionGenerator.Branches target) {
        switch (wanted) {
            case ALL -> {
                for (int i = 0; i < count; i++) {
                    Directions.draw(random, branch);
                    turnOver(branch, normal, side);
                    target.accept(branch);
                }
            }
            case DIRECTED -> drawDirected(branch, count, normal, side, random, target);
            case NONE -> SkippableRandom.skip(random, NUMBERS_PER_RAY * count);
        }
    }

    /**
     * The vertical component alone shows that most directions miss the sensor: unit vectors within the angle that it
     * subtends, of sine s, are at most 2 sin(asin(s) / 2) apart.
     */
    private void drawDirected(
            AcousticRay branch,
            int count,
            double[] normal,
            double side,
            RandomGenerator random,
            ReflectionGenerator.Branches target) {
        double x = sensor.x() - branch.originX;
        double y = sensor.y() - branch.originY;
        double z = sensor.z() - branch.originZ;
        if (side * (x * normal[0] + y * normal[1] + z * normal[2]) < -radius) {
            SkippableRandom.skip(random, NUMBERS_PER_RAY * count);
            return;
        }
        double distance = Math.sqrt(x * x + y * y + z * z);
        double sine = Math.min(1.0, radius / distance);
        double apart = distance > radius ? sine * Math.sqrt(2.0 / (1.0 + Math.sqrt(1.0 - sine * sine))) : 2.0;
        double vertical = Math.abs(z) / distance;
        for (int i = 0; i < count; i++) {
            double drawn = 2.0 * random.nextDouble() - 1.0;
            // The direction may yet be reversed: either sign counts.
            if (Math.abs(Math.abs(drawn) - vertical) > apart + ROUNDING) {
                SkippableRandom.skip(random, 1);
            } else {
                Directions.set(branch, drawn, random.nextDouble());
                turnOver(branch, normal, side);
                target.accept(branch);
            }
        }
    }

    /** Turns a ray uniform over the sphere to one side of the surface. */
    private static void turnOver(AcousticRay branch, double[] normal, double side) {
        double along = branch.directionX * normal[0] + branch.directionY * normal[1] + branch.directionZ * normal[2];
        if (side * along < 0.0) {
            branch.directionX = -branch.directionX;
            branch.directionY = -branch.directionY;
            branch.directionZ = -branch.directionZ;
        }
    }
}
