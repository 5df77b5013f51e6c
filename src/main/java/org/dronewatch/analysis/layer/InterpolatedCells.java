package org.dronewatch.analysis.layer;

import java.util.Optional;
import org.dronewatch.drone.Drone;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.InterpolableSensor;
import org.dronewatch.sensor.NormalTail;
import org.dronewatch.sensor.Signal;

/**
 * Assesses cells by interpolation. Where the signal in the open and the excesses of the neighbours leave no doubt, and
 * no shadow boundary is near, they decide; elsewhere the exact paths are found, and only what comes along other paths
 * is interpolated. The probability is 0 or 1 where the margin exceeds any error that is possible, otherwise the
 * probability that a normally distributed error leaves the margin positive.
 */
record InterpolatedCells(FieldProbe probe, ExcessMap excess, Assessor assessor) {

    /** The assessment of a drone. */
    Assessment assess(Drone there, Optional<Pointing> pointing) {
        Optional<Signal> traced =
                assessor.isSameAtAllHeadings(there, pointing) ? excess.traced(there.origin()) : Optional.empty();
        return traced.or(() -> interpolated(there))
                .map(signal -> assessor.assess(signal, there, pointing))
                .orElseGet(() -> probe.assessCoarsely(assessor, there, pointing));
    }

    /** Empty where there is nothing to interpolate between. */
    private Optional<Signal> interpolated(Drone there) {
        boolean isInSight = sensor().isInSight(probe.world(), there);
        return excess.at(there.origin(), isInSight).flatMap(estimate -> signal(there, isInSight, estimate));
    }

    private InterpolableSensor sensor() {
        return assessor.interpolable().orElseThrow();
    }

    private Optional<Signal> signal(Drone there, boolean isInSight, ExcessMap.Estimate rough) {
        InterpolationError error = excess.error();
        Signal open = sensor().signalInTheOpen(probe.world(), there).orElseThrow();
        double threshold = open.threshold();
        double beyond = error.bounds(isInSight).beyond();
        boolean isPlain = open.quantity() + rough.least() - beyond > threshold
                || open.quantity() + rough.greatest() + beyond < threshold;
        if (isPlain && excess.isFarFromShadowBoundaries(there.origin(), isInSight)) {
            return Optional.of(Signal.certain(open.quantity() + rough.overOpen(), open.unit(), threshold));
        }
        double exact = TracedPlace.over(open, sensor().signalOnExactPaths(probe.world(), there));
        return excess.at(there.origin(), isInSight, exact).map(estimate -> signal(open, exact, estimate, isInSight));
    }

    private Signal signal(Signal open, double exact, ExcessMap.Estimate estimate, boolean isInSight) {
        double threshold = open.threshold();
        double quantity = open.quantity() + estimate.over(open.quantity(), exact);
        double spread = estimate.spread(open.quantity(), exact);
        double deviation = excess.error().deviation(spread, isInSight);
        double margin = quantity - threshold;
        double probability = Math.abs(margin) > excess.error().greatest(spread, isInSight)
                ? margin > 0.0 ? 1.0 : 0.0
                : NormalTail.above(-margin / deviation);
        return new Signal(probability, quantity, open.unit(), threshold, deviation, 0.0);
    }
}
