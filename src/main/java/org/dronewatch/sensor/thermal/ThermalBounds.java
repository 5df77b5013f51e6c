package org.dronewatch.sensor.thermal;

import java.util.Optional;
import java.util.function.DoublePredicate;
import java.util.function.DoubleToIntFunction;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.SightCone;
import org.dronewatch.sensor.AssessmentBounds;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Cover;
import org.dronewatch.sensor.Outline;
import org.dronewatch.sensor.Signal;
import org.dronewatch.sensor.optics.AreaBounds;
import org.dronewatch.sensor.optics.SilhouetteArea;
import org.dronewatch.sensor.optics.VisibleArea;
import org.dronewatch.world.Obstacle;

/** Bounds on the assessments of a thermal camera, from bounds on a drone's area. Not thread-safe. */
final class ThermalBounds {
    private static final Position AT_REST = new Position(0, 0, 0);

    private final VisibleArea area;
    private final ThermalSignal signals;
    private final Cover cover;
    private final Position camera;
    private final Outline.Frustum outline;
    private final AreaBounds bounds;
    private final SilhouetteArea silhouette;
    private final SightCone sight;

    ThermalBounds(VisibleArea area, ThermalSignal signals, Cover cover) {
        this.area = area;
        this.signals = signals;
        this.cover = cover;
        this.camera = area.camera().position();
        this.outline = area.camera().outline();
        this.bounds = new AreaBounds(area.camera(), area.world());
        this.silhouette = new SilhouetteArea(area);
        this.sight = new SightCone(area.world().tree(), camera);
    }

    /** An upper bound on the signal of a drone. */
    Signal most(Drone drone) {
        return signals.of(drone, bounds.most(drone.origin(), drone.radius()));
    }

    /**
     * The bounds for a drone that is outside the image, that single triangles of the site hide, or whose signal is too
     * weak.
     */
    Optional<AssessmentBounds> atAllHeadings(Drone drone, Position at) {
        Drone there = drone.at(new FlightState(at, AT_REST, 0.0));
        double radius = there.radius();
        Signal nothing = signals.of(there, 0.0);
        if (area.camera().isOutside(at.x(), at.y(), at.z(), radius)) {
            return bounds(nothing, nothing, Cause.OUT_OF_VIEW);
        }
        if (!isInOutline(at)) {
            return Optional.empty();
        }
        Optional<Obstacle> before = cover.ofPoint(at);
        if (before.isPresent()) {
            return bounds.isHidden(at, radius)
                    ? bounds(
                            nothing,
                            nothing,
                            Cause.hiddenBy(before.get().model().role()))
                    : Optional.empty();
        }
        Signal most = signals.atRest(there, bounds.most(at, radius));
        return most.isDetected() ? Optional.empty() : bounds(nothing, most, Cause.TOO_WEAK);
    }

    /** The bounds for a level drone that nothing hides, from the silhouette of its model. */
    Optional<AssessmentBounds> of(Drone drone, FlightState state, DoubleToIntFunction steps) {
        Drone there = drone.at(state);
        if (!silhouette.bound(there, state) || !sight.isClear(state.position(), drone.radius())) {
            return Optional.empty();
        }
        if (!isDecisive(there, steps)) {
            boolean isLarge = signals.of(there, silhouette.likely()).isDetected();
            if (!silhouette.narrow(there, isLarge, () -> isDecisive(there, steps))) {
                return Optional.empty();
            }
        }
        Signal low = signals.of(there, silhouette.least());
        Signal high = signals.of(there, silhouette.most());
        Cause missed = isInOutline(state.position()) ? Cause.TOO_WEAK : Cause.OUT_OF_VIEW;
        return bounds(low, high, low.isDetected() ? Cause.DETECTED : missed);
    }

    /** Whether the bounds on the area of a drone decide its assessment. */
    private boolean isDecisive(Drone there, DoubleToIntFunction steps) {
        Signal low = signals.of(there, silhouette.least());
        Signal high = signals.of(there, silhouette.most());
        return low.isDetected() == high.isDetected()
                && steps.applyAsInt(low.probability()) == steps.applyAsInt(high.probability());
    }

    private boolean isInOutline(Position at) {
        return outline.contains(at.minus(camera));
    }

    private static Optional<AssessmentBounds> bounds(Signal weakest, Signal strongest, Cause cause) {
        return Optional.of(AssessmentBounds.between(weakest, strongest, cause));
    }

    /**
     * The area of a drone as given by {@link VisibleArea#of(Drone, DoublePredicate)}; faster if bounds have just been
     * found for its state.
     */
    double area(Drone drone, DoublePredicate enough) {
        if (!silhouette.isOf(drone)) {
            return area.of(drone, enough);
        }
        return sight.isClear(drone.origin(), drone.radius())
                ? area.ofClear(drone, silhouette, enough)
                : area.of(drone, silhouette, enough);
    }

    /** Whether a drone would be detected if nothing hid it; faster if bounds have just been found for its state. */
    boolean isDetectedInTheOpen(Drone drone) {
        if (!most(drone).isDetected()) {
            return false;
        }
        DoublePredicate enough = pixels -> signals.of(drone, pixels).isDetected();
        if (!silhouette.isOf(drone)) {
            return enough.test(area.inTheOpen(drone, enough));
        }
        return enough.test(silhouette.least())
                || enough.test(silhouette.most()) && enough.test(area.ofClear(drone, silhouette, enough));
    }
}
