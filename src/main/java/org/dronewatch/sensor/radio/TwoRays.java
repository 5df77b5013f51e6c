package org.dronewatch.sensor.radio;

import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.World;

/**
 * The interference of the direct wave with the wave reflected by the ground of a site. The reflecting surface is the
 * straight line along the path that best fits the heights of the site within the first Fresnel zone about the point of
 * reflection; the deviations from that line count as roughness. An obstacle that is near one of the two legs of the
 * reflected path, or obstructs it, weakens the reflection by its diffraction loss, so that the result has no step where
 * an edge rises into a leg. No reflection is counted where there is no ground. On a round earth, heights are measured
 * from a sphere that touches that line at the point of reflection. For use by one thread.
 */
public final class TwoRays {
    private static final double LIGHT = 299_792_458.0;

    /**
     * The number of iterations: enough for the point of reflection to converge if the ground is smooth enough to be
     * called a surface.
     */
    private static final int STEPS = 4;

    /**
     * The height above the fitted surface at which the legs of the reflected path meet, m; also in standard deviations.
     */
    private static final double CLEAR = 0.1;

    /**
     * Before the point of reflection is known, the surface is fitted along this fraction of the path to either side.
     */
    private static final double FIRST_REACH = 0.45;

    private static final double DEVIATIONS = 3.0;

    private final World world;
    private final ReflectingGround surface;
    private final SurfaceLine line;
    private final RadioPath legs;

    /**
     * The point of reflection of the current path: its horizontal distances from the beginning of the path and to its
     * end, m.
     */
    private double at;

    private double before;
    private double beyond;

    /** Heights of the ends of the path above the plane that touches the surface at that point, m. */
    private double one;

    private double other;

    /** Interference over the ground of a site. */
    public TwoRays(World world, ReflectingGround surface) {
        this.world = world;
        this.surface = surface;
        this.line = new SurfaceLine(world.newGround());
        this.legs = new RadioPath(world);
    }

    /**
     * The field at one end relative to that of the direct wave alone, dB, one way; 0 without a reflection.
     *
     * @param from the sensor, m
     * @param to the drone or the pilot, m
     * @param frequency carrier frequency, Hz
     * @param isVertical whether the wave is polarised vertically, not horizontally
     * @param isWithinBeam whether the sensor's antenna looks in the direction of a vector
     */
    public double factor(
            Position from, Position to, double frequency, boolean isVertical, Predicate<Position> isWithinBeam) {
        return weighted(from, to, frequency, isVertical, way -> isWithinBeam.test(way) ? 1.0 : 0.0);
    }

    /**
     * The field at one end relative to that of the direct wave alone, dB, one way; 0 without a reflection.
     *
     * @param from the sensor, m
     * @param to the drone or the pilot, m
     * @param frequency carrier frequency, Hz
     * @param isVertical whether the wave is polarised vertically, not horizontally
     * @param amplitude field amplitude that the sensor's antenna receives from the direction of a vector, relative to
     *     that from the drone or pilot; 0 outside its field of view
     */
    public double weighted(
            Position from, Position to, double frequency, boolean isVertical, ToDoubleFunction<Position> amplitude) {
        double width = Math.hypot(to.x() - from.x(), to.y() - from.y());
        double direct = from.distance(to);
        if (!(width > 0.0) || !findReflection(from, to, width, LIGHT / frequency)) {
            return 0.0;
        }
        double height = line.height(at);
        Position towards = on(from, to, at / width, height).minus(from);
        double share = amplitude.applyAsDouble(towards.times(direct / towards.length()));
        if (!(share > 0.0)) {
            return 0.0;
        }
        Position point = on(from, to, at / width, height + CLEAR + DEVIATIONS * line.uneven());
        double lost = legs.faintLoss(from, point, frequency) + legs.faintLoss(to, point, frequency);
        double reflected = Math.sqrt(direct * direct + 4.0 * one * other);
        // The difference of two nearly equal lengths, without cancellation.
        double longer = 4.0 * one * other / (reflected + direct);
        double sine = Math.min(1.0, (one + other) / reflected);
        double spread = surface.roundEarth() ? RoundEarth.divergence(before, beyond, sine) : 1.0;
        return surface.factor(
                direct,
                longer,
                Math.asin(sine),
                line.uneven(),
                frequency,
                isVertical,
                share * spread * Math.pow(10.0, -0.05 * lost));
    }

    /**
     * Finds the point at which the ground reflects; false if there is no ground, or if it lies above one of the ends.
     */
    private boolean findReflection(Position from, Position to, double width, double wavelength) {
        double direct = from.distance(to);
        at = 0.5 * width;
        double reach = FIRST_REACH * width;
        for (int i = 0; i < STEPS; i++) {
            if (!line.fit(from, to, width, at, reach) || !reflect(from, to, width)) {
                return false;
            }
            double span = before + beyond;
            double sine = (one + other) / Math.hypot(span, one + other);
            double zone = Math.sqrt(wavelength * direct * one * other / ((one + other) * (one + other)));
            reach = Math.min(zone / sine, 0.9 * Math.min(at, width - at));
        }
        return true;
    }

    /** Finds the point on the surface at which the two angles are equal; false if an end lies below the surface. */
    private boolean reflect(Position from, Position to, double width) {
        before = 0.0;
        beyond = 0.0;
        if (!measureHeights(from, to, width)) {
            return false;
        }
        // The feet of both ends on the surface, and the point between them.
        double tilt = Math.sqrt(1.0 + line.slope() * line.slope());
        double foot = one * line.slope() / tilt;
        double span = width + other * line.slope() / tilt - foot;
        before = surface.roundEarth() ? RoundEarth.reflection(one, other, span) : span * one / (one + other);
        beyond = span - before;
        at = Math.max(0.0, Math.min(width, foot + before));
        return measureHeights(from, to, width);
    }

    private boolean measureHeights(Position from, Position to, double width) {
        double tilt = Math.sqrt(1.0 + line.slope() * line.slope());
        one = (from.z() - line.height(0.0)) / tilt - drop(before);
        other = (to.z() - line.height(width)) / tilt - drop(beyond);
        return one > 0.0 && other > 0.0;
    }

    /** The depth of a round earth below the plane that represents the surface of a flat one, m. */
    private double drop(double distance) {
        return surface.roundEarth() ? RoundEarth.drop(distance) : 0.0;
    }

    private static Position on(Position from, Position to, double share, double height) {
        return new Position(from.x() + share * (to.x() - from.x()), from.y() + share * (to.y() - from.y()), height);
    }

    /** The site. */
    public World world() {
        return world;
    }
}
