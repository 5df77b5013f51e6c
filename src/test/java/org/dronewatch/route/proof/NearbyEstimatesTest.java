package org.dronewatch.route.proof;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.drone.Drone;
import org.dronewatch.sensor.Look;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Looks every half second, of which few of the first estimates show a detection. */
class NearbyEstimatesTest {
    private static final int LOOKS = 20;
    private static final RayEstimate NONE = new RayEstimate(2, 0.0, 0.0, 0.0, false);

    /** One of the 64 traces of two estimates. */
    private static final RayEstimate ONE = new RayEstimate(2, 1.0 / 32.0, 0.0, 0.0, false);

    @TempDir
    private Path directory;

    private static BegunFlight flight(FieldSite site, double begin, int detected, RayEstimate others) {
        Drone drone = site.stage().dronesAt(0.0).get(0);
        List<ScheduledLook> looks = new ArrayList<>();
        for (int i = 0; i < LOOKS; i++) {
            Look look = Look.of(1, "ear", i, begin + 0.5 * i);
            looks.add(new ScheduledLook(0, look, drone, i == detected ? ONE : others, true));
        }
        return new BegunFlight(
                site.settings(),
                site.stage().world(),
                new LookSchedule(List.copyOf(site.settings().enabledSensors().values()), looks, begin));
    }

    /** A detection at 5 s counts for all looks up to 1.5 s before and after it, from whatever moment they begin. */
    @Test
    void aDetectionSpeaksForItsNeighboursOnAllFlights() throws IOException {
        FieldSite site = FieldSite.in(
                directory,
                "  ear: {kind: acoustic, position: [0, 0, 2], rate: 2, propagation: {kind: level-model, initialRays: 2}}\n");
        BegunFlight first = flight(site, 0.0, 10, NONE);
        BegunFlight second = flight(site, 0.25, -1, NONE);
        NearbyEstimates nearby = new NearbyEstimates(List.of(first, second));

        // 7 looks of each flight with 64 traces each, one of which detects the drone.
        double near = ofTraces(1.0 / (2 * 7 * 64));
        // Elsewhere, no more is known than that one of all traces might have detected the drone.
        double far = ofTraces(1.0 / (2 * LOOKS * 64));
        for (int look = 0; look < LOOKS; look++) {
            boolean isNear = Math.abs(look - 10) <= 3;
            assertThat(nearby.variance(second, look)).as("look %d", look).isCloseTo(isNear ? near : 0.0, within(1e-15));
            assertThat(nearby.cautiousVariance(second, look)).isCloseTo(isNear ? near : far, within(1e-15));
        }
        assertThat(nearby.variance(first, 10))
                .as("its own estimates vary more")
                .isCloseTo(ofTraces(1.0 / 64.0), within(1e-15));
    }

    /** The variance of one estimate of 32 traces. */
    private static double ofTraces(double probability) {
        return probability * (1.0 - probability) / 32.0;
    }

    @Test
    void exactLooksDoNotVary() throws IOException {
        FieldSite site = FieldSite.in(
                directory,
                "  ear: {kind: acoustic, position: [0, 0, 2], rate: 2, propagation: {kind: level-model, initialRays: 2}}\n");
        BegunFlight flight = flight(site, 0.0, 10, RayEstimate.exact(0.3));

        assertThat(new NearbyEstimates(List.of(flight)).variance(flight, 9)).isZero();
        assertThat(new NearbyEstimates(List.of(flight)).cautiousVariance(flight, 9))
                .isZero();
    }
}
