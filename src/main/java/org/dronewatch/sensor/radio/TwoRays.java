package org.dronewatch.sensor.radio;

import java.util.OptionalDouble;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.Ground;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * The interference of the direct wave with the one that the ground of a site reflects. The reflecting surface is the
 * line that fits best, along the path, the heights of the site within the first Fresnel zone about the point of
 * reflection; the deviations from it count as roughness. No reflection is counted where the direct line is blocked,
 * where there is no ground, or where the ground hides the point of reflection from either end. On a round earth, the
 * heights above that line are those above a sphere. One per thread.
 */
public final class TwoRays {
    private static final double LIGHT = 299_792_458.0;

    /** Heights in a Fresnel zone. */
    private static final int SAMPLES = 9;

    /** Enough for the point of reflection to settle on ground that can be called a surface. */
    private static final int STEPS = 4;

    /** How far above the fitted surface both ends must see the point of reflection, m and in standard deviations. */
    private static final double CLEAR = 0.1;

    /** Before the point of reflection is known, the surface is fitted along this share of the path to either side. */
    private static final double FIRST_REACH = 0.45;

    private static final double DEVIATIONS = 3.0;

    private final World world;
    private final ReflectingGround surface;
    private final Ground ground;
    private final Visibility visibility;

    /** The surface along the current path: height where the path begins, slope, and standard deviation, m. */
    private double base;

    private double slope;
    private double uneven;

    /** Over the ground of a site. */
    public TwoRays(World world, ReflectingGround surface) {
        this.world = world;
        this.surface = surface;
        this.ground = world.newGround();
        this.visibility = new Visibility(world);
    }

    /**
     * How the field at one end differs from that in free space, dB, one way; 0 without a reflection.
     *
     * @param isWithinBeam whether the sensor's antenna looks in the direction of a vector
     */
    public double factor(
            Position from, Position to, double frequency, boolean isVertical, Predicate<Position> isWithinBeam) {
        return weighted(from, to, frequency, isVertical, way -> isWithinBeam.test(way) ? 1.0 : 0.0);
    }

    /**
     * How the field at one end differs from that in free space, dB, one way; 0 without a reflection.
     *
     * @param from the sensor, m
     * @param to the drone or the pilot, m
     * @param frequency Hz
     * @param isVertical whether the wave is polarised vertically, not horizontally
     * @param amplitude of the sensor's antenna in the direction of a vector, relative to that towards the drone or
     *     pilot; 0 where it does not look
     */
    public double weighted(
            Position from, Position to, double frequency, boolean isVertical, ToDoubleFunction<Position> amplitude) {
        double width = Math.hypot(to.x() - from.x(), to.y() - from.y());
        double direct = from.distance(to);
        if (!(width > 0.0) || !visibility.isFree(from, to)) {
            return 0.0;
        }
        double wavelength = LIGHT / frequency;
        double at = 0.5 * width;
        double reach = FIRST_REACH * width;
        double span = width;
        double before = at;
        for (int i = 0; i < STEPS; i++) {
            if (!fit(from, to, width, at, reach)) {
                return 0.0;
            }
            double tilt = Math.sqrt(1.0 + slope * slope);
            double one = (from.z() - base) / tilt;
            double other = (to.z() - base - slope * width) / tilt;
            if (!(one > 0.0 && other > 0.0)) {
                return 0.0;
            }
            // The feet of both ends on the surface, and the point between them where the angles are equal.
            double foot = one * slope / tilt;
            double far = width + other * slope / tilt;
            span = far - foot;
            before = surface.roundEarth() ? RoundEarth.reflection(one, other, span) : span * one / (one + other);
            at = Math.max(0.0, Math.min(width, foot + before));
            one -= drop(before);
            other -= drop(span - before);
            if (!(one > 0.0 && other > 0.0)) {
                return 0.0;
            }
            double sine = (one + other) / Math.hypot(span, one + other);
            double zone = Math.sqrt(wavelength * direct * one * other / ((one + other) * (one + other)));
            reach = Math.min(zone / sine, 0.9 * Math.min(at, width - at));
        }
        double tilt = Math.sqrt(1.0 + slope * slope);
        double one = (from.z() - base) / tilt - drop(before);
        double other = (to.z() - base - slope * width) / tilt - drop(span - before);
        double reflected = Math.sqrt(direct * direct + 4.0 * one * other);
        double height = base + slope * at;
        Position point = on(from, to, at / width, height + CLEAR + DEVIATIONS * uneven);
        Position towards = on(from, to, at / width, height).minus(from);
        double share = amplitude.applyAsDouble(towards.times(direct / towards.length()));
        boolean isSeen = share > 0.0 && visibility.isFree(from, point) && visibility.isFree(to, point);
        if (!isSeen) {
            return 0.0;
        }
        // The difference of two nearly equal lengths, without cancellation.
        double longer = 4.0 * one * other / (reflected + direct);
        double grazing = Math.asin(Math.min(1.0, (one + other) / reflected));
        double spread =
                surface.roundEarth() ? RoundEarth.divergence(before, span - before, (one + other) / reflected) : 1.0;
        return surface.factor(direct, longer, grazing, uneven, frequency, isVertical, share * spread);
    }

    /** How far a round earth drops below the plane that the surface is otherwise, m. */
    private double drop(double distance) {
        return surface.roundEarth() ? RoundEarth.drop(distance) : 0.0;
    }

    /** Fits the surface to the heights about a place on the path; false without ground there. */
    private boolean fit(Position from, Position to, double width, double at, double reach) {
        double sum = 0.0;
        double sumX = 0.0;
        double[] heights = new double[SAMPLES];
        double[] places = new double[SAMPLES];
        for (int i = 0; i < SAMPLES; i++) {
            places[i] = at + reach * (2.0 * i / (SAMPLES - 1) - 1.0);
            Position place = on(from, to, places[i] / width, 0.0);
            OptionalDouble height = ground.height(place.x(), place.y());
            if (height.isEmpty()) {
                return false;
            }
            heights[i] = height.getAsDouble();
            sum += heights[i];
            sumX += places[i];
        }
        double mean = sum / SAMPLES;
        double middle = sumX / SAMPLES;
        double square = 0.0;
        double product = 0.0;
        for (int i = 0; i < SAMPLES; i++) {
            square += (places[i] - middle) * (places[i] - middle);
            product += (places[i] - middle) * (heights[i] - mean);
        }
        slope = square > 0.0 ? product / square : 0.0;
        base = mean - slope * middle;
        double squares = 0.0;
        for (int i = 0; i < SAMPLES; i++) {
            double off = heights[i] - base - slope * places[i];
            squares += off * off;
        }
        uneven = Math.sqrt(squares / SAMPLES);
        return true;
    }

    private static Position on(Position from, Position to, double share, double height) {
        return new Position(from.x() + share * (to.x() - from.x()), from.y() + share * (to.y() - from.y()), height);
    }

    /** The site. */
    public World world() {
        return world;
    }
}
