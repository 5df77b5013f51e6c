package org.dronewatch.route.proof;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.route.FlownExposure;
import org.dronewatch.route.FlownExposure.Step;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.SiteRoutes;
import org.dronewatch.route.search.WeakestRoute;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The cells promise that nothing detects the drone. The looks along the routes from the south are made up: they detect
 * it halfway, and perhaps too late, when it arrives.
 */
class RepeatedSearchTest {
    private static final int SOUTH = 4;
    private static final double RESPONSE = 5.0;

    private static final String SCENE =
            """
              far: {kind: radar, position: [0, 3000, 4], maxRange: 100, budget: {range: 100, crossSection: 0.01}}
            alert: {protect: {centre: [0, 0, 10], radius: 30}, response: 5 s}
            """;

    @TempDir
    private Path directory;

    /** From the south, in the order in which the looks along them were assessed. */
    private final List<SectorRoute> assessed = new ArrayList<>();

    private final AtomicInteger progress = new AtomicInteger();

    private SiteRoutes site;
    private RouteSurvey survey;

    @BeforeEach
    void search() throws IOException {
        FieldSite flown = FieldSite.in(directory, SCENE);
        FieldGrid grid = new FieldGrid(0, 0, 400, 20, List.of(10.0, 30.0));
        site = SiteRoutes.of(flown.field(grid, 1), flown.settings(), flown.stage(), FieldSite.DRONE);
        survey = RouteSurvey.of(site, RESPONSE, sector -> {}, () -> {});
    }

    /** The exposure to the looks along the routes from the south by their number, from 0: in time, and too late. */
    private RepeatedSearch searching(IntFunction<double[]> exposures) {
        return new RepeatedSearch(site, survey, route -> {
            if (route.sector() != SOUTH) {
                return route;
            }
            double[] exposure = exposures.apply(assessed.size());
            double end = route.searched().end().time();
            SectorRoute flown = route.with(new FlownExposure(
                    List.of(List.of(
                            new Step(0.5 * end - 1.0, 0.5 * end, exposure[0]), new Step(end - 1.0, end, exposure[1]))),
                    Map.of("far", exposure[0] + exposure[1])));
            assessed.add(flown);
            return flown;
        });
    }

    /** The number of the route from the south that is kept in the end, from 0. */
    private int kept(IntFunction<double[]> exposures) {
        RepeatedSearch search = searching(exposures);
        search.assess(progress::addAndGet);
        assertThat(progress).hasValue(SiteRoutes.SECTORS);
        progress.set(0);
        search.repeat(progress::addAndGet);
        assertThat(search.survey().isComplete()).isTrue();
        assertThat(search.survey().routes())
                .hasSize(SiteRoutes.SECTORS)
                .allMatch(route ->
                        route.sector() == SOUTH || route == survey.routes().get(route.sector()));
        SectorRoute kept = search.survey().routes().get(SOUTH);
        return IntStream.range(0, assessed.size())
                .filter(number -> assessed.get(number) == kept)
                .findFirst()
                .orElseThrow();
    }

    @Test
    void nothingIsRepeatedWhereTheSearchExpectedTheLooks() {
        RepeatedSearch search = searching(number -> new double[] {0.2, 3.0});
        search.assess(progress::addAndGet);

        assertThat(search.isNeeded()).isFalse();
        assertThat(search.survey().routes()).containsOnlyOnceElementsOf(assessed);
        progress.set(0);
        search.repeat(progress::addAndGet);
        assertThat(assessed).hasSize(1);
        assertThat(progress).hasValue(0);
    }

    /** As many are detected in time on the route that is least exposed all the way, but none at all. */
    @Test
    void lateDetectionsAreAvoided() {
        RepeatedSearch search = searching(number -> new double[] {0.0, number == 0 ? 3.0 : 0.0});
        search.assess(progress::addAndGet);
        assertThat(search.isTooLate()).isTrue();
        search.avoidLateDetections(progress::addAndGet);

        assertThat(assessed).hasSize(2);
        assertThat(search.survey().routes().get(SOUTH)).isSameAs(assessed.get(1));
        assertThat(search.isTooLate()).isFalse();
    }

    /** The first route that is least exposed all the way in the cells is detected when it is flown. */
    @Test
    void lateDetectionsAreAvoidedPastWhatLooksShow() {
        RepeatedSearch search = searching(number -> new double[] {0.0, number < 2 ? 3.0 : 0.0});
        search.assess(progress::addAndGet);
        progress.set(0);
        search.avoidLateDetections(progress::addAndGet);

        assertThat(assessed).hasSize(3);
        assertThat(progress).hasValue(2);
        assertThat(search.survey().routes().get(SOUTH)).isSameAs(assessed.get(2));
    }

    /** Not at the price of detections in time; and each sector is searched once. */
    @Test
    void lateDetectionsAreBetterThanTimelyOnes() {
        RepeatedSearch search = searching(number -> number == 0 ? new double[] {0.0, 3.0} : new double[] {0.01, 0.0});
        search.assess(progress::addAndGet);
        search.avoidLateDetections(progress::addAndGet);
        search.avoidLateDetections(progress::addAndGet);

        assertThat(assessed).hasSize(2);
        assertThat(search.survey().routes().get(SOUTH)).isSameAs(assessed.get(0));
        assertThat(search.isTooLate()).isFalse();
    }

    /** Nothing detects the drone on the route round the place at which the looks detected it before. */
    @Test
    void theSearchIsRepeatedUntilItExpectsTheLooks() {
        int kept = kept(number -> new double[] {number == 0 ? 3.0 : 0.0, 0.0});

        assertThat(assessed).hasSize(2);
        assertThat(progress).hasValue(1);
        assertThat(kept).isEqualTo(1);
        WeakestRoute before = assessed.get(0).route();
        WeakestRoute after = assessed.get(1).route();
        assertThat(after.path()).isNotEqualTo(before.path());
        assertThat(after.seconds()).isGreaterThan(before.seconds());
        assertThat(after.lower()).isEqualTo(before.lower());
    }

    /** Four times at most, and the best of five routes is kept. */
    @Test
    void theBestOfAllRoutesIsKept() {
        int kept = kept(number -> new double[] {number == 2 ? 1.0 : 3.0 + number, 0.0});

        assertThat(assessed).hasSize(RepeatedSearch.MOST + 1);
        assertThat(progress).hasValue(RepeatedSearch.MOST);
        assertThat(kept).isEqualTo(2);
    }

    /** Both are detected in time with a probability of 95 % in tables, and at all with 98 and 95 %. */
    @Test
    void ofRoutesThatAreDetectedInTimeAsOftenTheOneThatIsDetectedLessOftenIsKept() {
        double[][] exposures = {{3.0, 1.0}, {3.001, 0.0}, {4.0, 0.0}};

        assertThat(kept(number -> exposures[Math.min(number, 2)])).isEqualTo(1);
        assertThat(assessed.get(1).inTime(RESPONSE))
                .isGreaterThan(assessed.get(0).inTime(RESPONSE));
    }

    /** Both are detected in time with a probability of 95 % in tables, and at all with 98 and almost 100 %. */
    @Test
    void aRouteThatIsDetectedMoreOftenIsNotKeptForDigitsThatAreNotPrinted() {
        double[][] exposures = {{3.0, 1.0}, {2.999, 3.0}};

        assertThat(kept(number -> exposures[Math.min(number, 1)])).isZero();
        assertThat(assessed.get(1).inTime(RESPONSE)).isLessThan(assessed.get(0).inTime(RESPONSE));
    }

    /** The cells expect nothing of any route. */
    @Test
    void ofRoutesThatAreDetectedAsOftenTheShortestIsKept() {
        int kept = kept(number -> new double[] {3.0 - 1e-4 * number, 1.0});
        List<Long> tenths = assessed.stream()
                .map(route -> Math.round(10.0 * route.route().seconds()))
                .toList();

        assertThat(tenths).hasSize(RepeatedSearch.MOST + 1);
        assertThat(kept).isEqualTo(tenths.indexOf(Collections.min(tenths)));
        assertThat(kept).isNotEqualTo(RepeatedSearch.MOST);
    }

    /** In the middle of the second repetition, say. */
    @Test
    void theBestRoutesSoFarSurviveAnInterruption() {
        RepeatedSearch search = searching(number -> {
            if (number == 2) {
                throw new CancellationException();
            }
            return new double[] {3.0 - number, 0.0};
        });
        search.assess(progress::addAndGet);
        assertThat(search.isNeeded()).isTrue();

        assertThatThrownBy(() -> search.repeat(progress::addAndGet)).isInstanceOf(CancellationException.class);
        assertThat(search.survey().routes()).hasSize(SiteRoutes.SECTORS).contains(assessed.get(1));
    }

    @Test
    void beforeAllLooksAreAssessedTheSurveyIsNotComplete() {
        RepeatedSearch search = searching(number -> {
            throw new CancellationException();
        });

        assertThatThrownBy(() -> search.assess(progress::addAndGet)).isInstanceOf(CancellationException.class);
        assertThat(search.survey().routes()).hasSize(SOUTH);
        assertThat(search.survey().isComplete()).isFalse();
    }
}
