package org.dronewatch.sensor.acoustic.level;

import java.util.random.RandomGenerator;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.Directions;

/**
 * Draws the rays that a surface scatters, uniformly over a hemisphere. It uses the same random numbers whichever rays
 * are wanted. Immutable.
 */
final class ScatteredRays {
    /** A tolerance above the rounding error of directions. */
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
         * Which scattered rays are wanted.
         *
         * @param branch a ray with the origin, level and order of the scattered rays, in any direction
         */
        Wanted of(AcousticRay branch);
    }

    /**
     * Rays that may be directed at a sensor.
     *
     * @param sensor centre of the sensor, m
     * @param radius radius within which rays count as directed at the sensor, m
     */
    ScatteredRays(Position sensor, double radius) {
        this.sensor = sensor;
        this.radius = radius;
    }

    /**
     * Draws rays on one side of a surface.
     *
     * @param branch one of these rays; the object is reused
     * @param count number of rays that are drawn
     * @param normal unit normal of the surface
     * @param side 1 for the side of the normal, -1 for the other one
     * @param target receives the rays that are wanted
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
     * Draws rays of which only those directed at the sensor are wanted. The vertical component alone shows that most
     * directions miss the sensor: unit vectors within the angle that it subtends, of sine s, are at most 2 sin(asin(s)
     * / 2) apart.
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
            // The direction may still be reversed, so either sign counts.
            if (Math.abs(Math.abs(drawn) - vertical) > apart + ROUNDING) {
                SkippableRandom.skip(random, 1);
            } else {
                Directions.set(branch, drawn, random.nextDouble());
                turnOver(branch, normal, side);
                target.accept(branch);
            }
        }
    }

    /** Turns a ray, whose direction is uniformly distributed over the sphere, to one side of the surface. */
    private static void turnOver(AcousticRay branch, double[] normal, double side) {
        double along = branch.directionX * normal[0] + branch.directionY * normal[1] + branch.directionZ * normal[2];
        if (side * along < 0.0) {
            branch.directionX = -branch.directionX;
            branch.directionY = -branch.directionY;
            branch.directionZ = -branch.directionZ;
        }
    }
}
