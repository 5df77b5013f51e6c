package org.dronewatch.sensor.camera;

import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleToIntFunction;
import java.util.function.IntPredicate;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.AssessmentBounds;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Cover;
import org.dronewatch.sensor.Signal;
import org.dronewatch.sensor.optics.DronePicture;
import org.dronewatch.sensor.optics.PixelBounds;
import org.dronewatch.world.Obstacle;
import org.dronewatch.world.World;

/**
 * Bounds on the assessments of a camera whose signal grows with the number of pixels, from bounds on that number. The
 * cause follows the rules for an exact look ({@link Cover#explain}); a ray is traced for it only where it matters. For
 * use by one thread at a time.
 */
final class CameraBounds {
    private static final Position AT_REST = new Position(0, 0, 0);

    /** The signals for fewer pixels than this are kept for reuse. */
    private static final int KEPT = 1 << 10;

    private final World world;
    private final CameraSignal signals;
    private final Cover cover;

    // The position of the last query, and the obstacle in front of it.
    private Position asked;
    private Optional<Obstacle> obstacle = Optional.empty();

    /** The bounds for a drone that no pixel shows, by cause, if they are the same at all positions. */
    private final Map<Cause, Optional<AssessmentBounds>> unseen = new EnumMap<>(Cause.class);

    /** The signals by number of pixels, if they depend on nothing else; null for those not needed so far. */
    private final Signal[] known = new Signal[KEPT];

    CameraBounds(World world, CameraSignal signals, Cover cover) {
        this.world = world;
        this.signals = signals;
        this.cover = cover;
    }

    /**
     * Bounds that hold at all headings and speeds: those for a drone that is outside the image, or that the site hides.
     *
     * @param picture the pictures of the camera as it is pointed
     */
    Optional<AssessmentBounds> atAllHeadings(DronePicture picture, Drone drone, Position at) {
        double radius = drone.silhouettes().radius();
        if (picture.camera().isOutside(at.x(), at.y(), at.z(), radius)) {
            return unseen(picture, at, Cause.OUT_OF_VIEW);
        }
        return picture.isInvisible(world, drone.silhouettes(), at) && isInOutline(picture, at)
                ? obstacle(at)
                        .flatMap(before -> unseen(
                                picture, at, Cause.hiddenBy(before.model().role())))
                : Optional.empty();
    }

    /**
     * The bounds for a drone that no pixel shows: neither heading nor speed matters then, nor does the position if only
     * pixels count.
     */
    private Optional<AssessmentBounds> unseen(DronePicture picture, Position at, Cause cause) {
        if (!signals.countPixelsOnly()) {
            return boundsUnseen(picture, at, cause);
        }
        Optional<AssessmentBounds> known = unseen.get(cause);
        if (known == null) {
            known = boundsUnseen(picture, at, cause);
            unseen.put(cause, known);
        }
        return known;
    }

    private Optional<AssessmentBounds> boundsUnseen(DronePicture picture, Position at, Cause cause) {
        Signal nothing = signals.of(
                signals.view(at, AT_REST, 0, Optional.empty(), picture.camera().focalLength()));
        return Optional.of(AssessmentBounds.between(nothing, nothing, nothing.isDetected() ? Cause.DETECTED : cause));
    }

    private static boolean isInOutline(DronePicture picture, Position at) {
        return picture.camera().outline().contains(at.minus(picture.camera().position()));
    }

    private Optional<Obstacle> obstacle(Position at) {
        if (!at.equals(asked)) {
            asked = at;
            obstacle = cover.ofPoint(at);
        }
        return obstacle;
    }

    /**
     * Bounds for a level state of flight.
     *
     * @param steps maps a probability to a step; probabilities of the same step count as equal
     * @return empty where it is faster to draw the drone
     */
    Optional<AssessmentBounds> of(
            DronePicture picture,
            Drone drone,
            FlightState state,
            Optional<Pointing> pointing,
            DoubleToIntFunction steps) {
        Optional<PixelBounds> found = picture.bounds(world, drone.silhouettes(), state.position());
        if (found.isEmpty()) {
            return Optional.empty();
        }
        PixelBounds pixels = found.get();
        State there = new State(picture, state, pointing);
        int greatest = steps.applyAsInt(there.signal(pixels.mostAround()).probability());
        IntPredicate enough = new Enough(number -> there.isDetectedIn(number, greatest, steps));
        if (enough.test(pixels.mostAround())) {
            // The first rows may suffice; a sample hardly ever does.
            pixels.examineAll();
        }
        pixels.count(state.heading(), enough);
        Optional<AssessmentBounds> bounds = there.bounds(pixels, steps);
        if (bounds.isEmpty() && pixels.examineAll()) {
            pixels.count(state.heading(), enough);
            bounds = there.bounds(pixels, steps);
        }
        return bounds.isEmpty()
                        && picture.refine(pixels, drone.at(state), enough, () -> there.bounds(pixels, steps)
                                .isPresent())
                ? there.bounds(pixels, steps)
                : bounds;
    }

    /**
     * The greatest margin as in {@link CameraSensor#greatestMarginDb}: that of a drone that fills the rectangle around
     * it.
     */
    double greatestMarginDb(DronePicture picture, Drone drone, FlightState state, Optional<Pointing> pointing) {
        State there = new State(picture, state, pointing);
        return picture.bounds(world, drone.silhouettes(), state.position())
                .map(pixels -> there.range(0, pixels.mostInRectangle()).greatestMarginDb)
                .orElse(Double.POSITIVE_INFINITY);
    }

    /**
     * A condition that holds for some number of pixels and for any greater one, evaluated only where earlier answers
     * leave it open. For no pixel at all, it is always evaluated, since the result may then follow a different rule.
     */
    private static final class Enough implements IntPredicate {
        private final IntPredicate condition;
        private int tooFew;
        private int sufficient = Integer.MAX_VALUE;

        Enough(IntPredicate condition) {
            this.condition = condition;
        }

        @Override
        public boolean test(int pixels) {
            if (pixels > 0 && (pixels <= tooFew || pixels >= sufficient)) {
                return pixels >= sufficient;
            }
            boolean holds = condition.test(pixels);
            if (holds && pixels > 0) {
                sufficient = pixels;
            } else if (pixels > 0) {
                tooFew = pixels;
            }
            return holds;
        }
    }

    /** A state of flight in which the drone may be. */
    private final class State {
        private final DronePicture picture;
        private final FlightState state;
        private final Optional<Pointing> pointing;

        /** The view of a drone in this state that one pixel shows; null until it is needed. */
        private DroneView visible;

        State(DronePicture picture, FlightState state, Optional<Pointing> pointing) {
            this.picture = picture;
            this.state = state;
            this.pointing = pointing;
        }

        /** Whether a number of pixels is sufficient for a step of the probability. */
        boolean isDetectedIn(int pixels, int step, DoubleToIntFunction steps) {
            Signal signal = signal(pixels);
            return signal.isDetected() && steps.applyAsInt(signal.probability()) == step;
        }

        /** The bounds on the assessment; empty where they are too far apart, or the cause is not certain. */
        Optional<AssessmentBounds> bounds(PixelBounds pixels, DoubleToIntFunction steps) {
            Range seen = range(pixels.least(), pixels.most());
            return steps.applyAsInt(seen.least) == steps.applyAsInt(seen.greatest)
                    ? cause(pixels, seen).map(seen::bounds)
                    : Optional.empty();
        }

        private Optional<Cause> cause(PixelBounds pixels, Range seen) {
            if (seen.isDetected) {
                return Optional.of(Cause.DETECTED);
            }
            if (!seen.isMissed) {
                return Optional.empty();
            }
            if (!isInOutline(picture, state.position())) {
                return Optional.of(Cause.OUT_OF_VIEW);
            }
            Range inTheOpen = range(pixels.leastInTheOpen(), pixels.mostInTheOpen());
            if (inTheOpen.isMissed && pixels.least() > 0) {
                return Optional.of(Cause.TOO_WEAK);
            }
            Optional<Obstacle> before = obstacle(state.position());
            if (before.isEmpty()) {
                return inTheOpen.isMissed ? Optional.of(Cause.TOO_WEAK) : Optional.empty();
            }
            return pixels.most() == 0 || inTheOpen.isDetected
                    ? before.map(one -> Cause.hiddenBy(one.model().role()))
                    : Optional.empty();
        }

        /** The range of signals between two numbers of pixels; zero pixels are treated separately. */
        private Range range(int least, int most) {
            Signal low = signal(least);
            Signal high = signal(most);
            if (least > 0 || most == 0) {
                return new Range(
                        low.probability(),
                        high.probability(),
                        low.marginDb(),
                        high.marginDb(),
                        low.isDetected(),
                        !high.isDetected());
            }
            Signal one = signal(1);
            return new Range(
                    Math.min(low.probability(), one.probability()),
                    Math.max(low.probability(), high.probability()),
                    Math.min(low.marginDb(), one.marginDb()),
                    Math.max(low.marginDb(), high.marginDb()),
                    low.isDetected() && one.isDetected(),
                    !low.isDetected() && !high.isDetected());
        }

        private Signal signal(int pixels) {
            if (pixels >= KEPT || !signals.countPixelsOnly()) {
                return newSignal(pixels);
            }
            Signal signal = known[pixels];
            if (signal == null) {
                signal = newSignal(pixels);
                known[pixels] = signal;
            }
            return signal;
        }

        private Signal newSignal(int pixels) {
            if (pixels == 0) {
                return signals.of(view(0));
            }
            if (visible == null) {
                visible = view(1);
            }
            return signals.of(visible.withPixels(pixels));
        }

        private DroneView view(int pixels) {
            return signals.view(
                    state.position(),
                    state.velocity(),
                    pixels,
                    pointing,
                    picture.camera().focalLength());
        }
    }

    /** The signals between two numbers of pixels, and whether the drone is certainly detected or certainly missed. */
    private record Range(
            double least,
            double greatest,
            double leastMarginDb,
            double greatestMarginDb,
            boolean isDetected,
            boolean isMissed) {
        AssessmentBounds bounds(Cause cause) {
            return new AssessmentBounds(least, greatest, leastMarginDb, greatestMarginDb, cause);
        }
    }
}
