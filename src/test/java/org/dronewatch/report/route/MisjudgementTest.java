package org.dronewatch.report.route;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.FlownExposure;
import org.dronewatch.route.RouteCauses;
import org.dronewatch.route.RoutePoint;
import org.dronewatch.route.RouteProfile;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.search.RoutePath;
import org.dronewatch.route.search.WeakestRoute;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A flight of 30 s, as the search expects it, as looks at any moment would see it, and as slow looks do. */
class MisjudgementTest {
    private static final double RESPONSE = 15.0;

    /** In percent; in the third case, looks at any moment are farther from the search than the flight is. */
    @ParameterizedTest
    @CsvSource({
        "50, 50, 50, ",
        "50, 70, 69, ",
        "47, 58, 54, ",
        "47, 80, 54, ",
        "0, 100, 0, ",
        "20, 60, 60, CELLS",
        "60, 20, 20, CELLS",
        "20, 70, 55, CELLS",
        "100, 95, 25, SCANS",
        "60, 100, 30, SCANS",
        "90, 70, 50, BOTH",
        "100, 50, 10, BOTH",
        "90, 85, 69, SCANS",
        "90, 75, 69, CELLS"
    })
    void namesTheStepThatLeadsThere(double searched, double byFastLooks, double flown, Misjudgement cause) {
        assertThat(Misjudgement.of(searched / 100.0, byFastLooks / 100.0, flown / 100.0))
                .isEqualTo(Optional.ofNullable(cause));
    }

    /** Of looks in time or too late, in one flight or, with the second of these exposures, in half of two. */
    private static SectorRoute route(double counted, double all, double time, double exposure, boolean isInAll) {
        Position start = new Position(0, 300, 30);
        Position end = new Position(0, 0, 30);
        List<FlownExposure.Step> looks = List.of(new FlownExposure.Step(time - 1.0, time, exposure));
        SectorRoute route = new SectorRoute(
                0,
                new WeakestRoute(new RoutePath(List.of(start, end), List.of(0)), counted, 0, 30),
                new RouteProfile(List.of(
                        new RoutePoint(0, 0, start, 30, 0, 0, true), new RoutePoint(30, 300, end, 30, 0, all, true))),
                Map.of("radar", all),
                RouteCauses.NONE,
                Optional.empty());
        assertThat(Misjudgement.inTime(route, RESPONSE)).isEmpty();
        assertThat(Misjudgement.tooLate(route, RESPONSE)).isEmpty();
        List<List<FlownExposure.Step>> flights = isInAll ? List.of(looks) : List.of(looks, List.of());
        return route.with(new FlownExposure(flights, Map.of("radar", exposure)));
    }

    @Test
    void aDetectionThatComesTooLateCountsOnlyWithoutAResponse() {
        SectorRoute late = route(0.0, 3.0, 20.0, 1e-6, true);
        SectorRoute early = route(3.0, 3.0, 10.0, 1e-6, true);

        assertThat(Misjudgement.inTime(late, RESPONSE)).isEmpty();
        assertThat(Misjudgement.tooLate(late, RESPONSE)).contains(Misjudgement.CELLS);
        assertThat(Misjudgement.inTime(early, RESPONSE)).contains(Misjudgement.CELLS);
        assertThat(Misjudgement.tooLate(early, RESPONSE)).isEmpty();
        assertThat(Misjudgement.inTime(early, 0.0)).contains(Misjudgement.CELLS);
        assertThat(Misjudgement.tooLate(early, 0.0)).isEmpty();
    }

    /** Half of the flights are certain to be detected, all of which a sensor that looked all the time would detect. */
    @Test
    void slowLooksMissWhatLooksAtAnyMomentWouldDetect() {
        SectorRoute inTime = route(20.0, 20.0, 10.0, 40.0, false);
        SectorRoute late = route(0.0, 20.0, 20.0, 40.0, false);

        assertThat(Misjudgement.inTime(inTime, RESPONSE)).contains(Misjudgement.SCANS);
        assertThat(Misjudgement.inTime(late, RESPONSE)).isEmpty();
        assertThat(Misjudgement.tooLate(late, RESPONSE)).contains(Misjudgement.SCANS);
        assertThat(inTime.left()).isEqualTo(OptionalDouble.of(20.0));
    }

    @Test
    void whatHelpsFollowsFromTheCause() {
        assertThat(Misjudgement.CELLS.isForCells()).isTrue();
        assertThat(Misjudgement.SCANS.isForCells()).isFalse();
        assertThat(Misjudgement.BOTH.isForCells()).isTrue();
    }
}
