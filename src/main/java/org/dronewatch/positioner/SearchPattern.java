package org.dronewatch.positioner;

import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/** The pattern of a positioner's search until it is cued, relative to the aim in the sensor's settings. */
public sealed interface SearchPattern {

    /**
     * The direction at a time.
     *
     * @param aim the direction of the aim in the sensor's settings
     * @param time seconds since the start of the run
     */
    Direction at(Direction aim, double time);

    /** The time after which the pattern repeats itself, s; 0 if it does not move. */
    double period();

    /** A triangle wave: the position between 0 and a length after a distance travelled back and forth. */
    private static double triangleWave(double travelled, double length) {
        double phase = travelled - 2.0 * length * Math.floor(travelled / (2.0 * length));
        return phase <= length ? phase : 2.0 * length - phase;
    }

    /** A search pattern that stays at the aim in the sensor's settings. */
    record Rest() implements SearchPattern {
        @Override
        public double period() {
            return 0.0;
        }

        @Override
        public Direction at(Direction aim, double time) {
            return aim;
        }
    }

    /**
     * A continuous clockwise rotation.
     *
     * @param speed pan rate, above 0 and at most 10 pi/3 rad/s
     */
    record Round(@In(value = Quantity.ANGULAR_SPEED, above = 0, to = 10 * Math.PI / 3) double speed)
            implements SearchPattern {
        /** One rotation in 36 s. */
        @Defaults
        public static final Round DEFAULT = new Round(Math.toRadians(10.0));

        /** Checks the limits. */
        public Round {
            Limits.check(Round.class, speed);
        }

        @Override
        public double period() {
            return 2.0 * Math.PI / speed;
        }

        @Override
        public Direction at(Direction aim, double time) {
            return aim.turned(speed * time, 0.0);
        }
    }

    /**
     * A scan of a sector: back and forth in one row or, with several rows, row by row from the lowest row up and back
     * down. The scan begins at the left.
     *
     * @param width width of the sector, centred on the aim, pi/1800 (0.1 degrees) to 2 pi rad
     * @param height height of the sector, centred on the aim, 0 to pi/2 rad
     * @param rows number of rows, 1 to 100; a single row lies at mid-height
     * @param speed pan rate, above 0 and at most 10 pi/3 rad/s
     */
    record Sweep(
            @In(value = Quantity.ANGLE, from = Math.PI / 1800, to = 2 * Math.PI) double width,
            @In(value = Quantity.ANGLE, from = 0, to = Math.PI / 2) double height,
            @In(value = Quantity.NUMBER, from = 1, to = 100) int rows,
            @In(value = Quantity.ANGULAR_SPEED, above = 0, to = 10 * Math.PI / 3) double speed)
            implements SearchPattern {
        /** Checks the limits. */
        public Sweep {
            Limits.check(Sweep.class, width, height, rows, speed);
        }

        /** A scan back and forth in one row at 10 degrees per second, over a sector of a given width, rad. */
        @Defaults("width")
        public static Sweep of(double width) {
            return new Sweep(width, 0.0, 1, Math.toRadians(10.0));
        }

        @Override
        public double period() {
            return 2.0 * rows * width / speed;
        }

        @Override
        public Direction at(Direction aim, double time) {
            double travelled = triangleWave(speed * time, rows * width);
            int row = Math.min(rows - 1, (int) (travelled / width));
            double inRow = travelled - row * width;
            double across = row % 2 == 0 ? inRow : width - inRow;
            double up = rows == 1 ? 0.0 : height * (row / (rows - 1.0) - 0.5);
            return aim.turned(across - 0.5 * width, up);
        }
    }
}
