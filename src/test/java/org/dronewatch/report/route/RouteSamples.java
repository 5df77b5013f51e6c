package org.dronewatch.report.route;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.fusion.ProtectedZone;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.FlownExposure;
import org.dronewatch.route.RouteCauses;
import org.dronewatch.route.RoutePoint;
import org.dronewatch.route.RouteProfile;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.proof.RouteProof;
import org.dronewatch.route.proof.UnseenPlaces;
import org.dronewatch.route.search.RouteMode;
import org.dronewatch.route.search.RoutePath;
import org.dronewatch.route.search.TimeToGo;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.SettingsForm;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/** A route of 30 s with one look after 10 s, which is in time for a response of 15 s, and variants of it. */
abstract class RouteSamples {
    static final Position START = new Position(0, 300, 30);

    static final Position END = new Position(0, 0, 30);

    @TempDir
    Path directory;

    FieldSite site;

    RouteInputs inputs;

    @BeforeEach
    void load() throws IOException {
        site = FieldSite.in(
                directory,
                """
                  slow: {kind: radar, position: [0, 0, 4], rate: 0.2, minRange: 1, maxRange: 100, elevationWidth: 90 deg,
                    budget: {range: 500, crossSection: 0.01}, minSpeed: 0 m/s}
                  slower: {kind: radar, position: [0, 0, 4], rate: 0.05, minRange: 1, maxRange: 100,
                    elevationWidth: 90 deg, budget: {range: 500, crossSection: 0.01}, minSpeed: 0 m/s}
                """);
        SceneSettings settings = SettingsForm.with(
                site.settings(), "alert", site.settings().alert().withProtectedZone(ProtectedZone.at(END), 15.0));
        inputs = new RouteInputs(
                "site",
                FieldSite.DRONE,
                settings,
                site.stage().protection(),
                new FieldGrid(0.0, 0.0, 600.0, 20.0, List.of(30.0)),
                FieldTerms.Turning.SEARCH,
                Optional.empty(),
                Optional.empty());
    }

    static SectorRoute route(Map<String, Double> bySensor, double searched, List<List<FlownExposure.Step>> flown) {
        RoutePath path = new RoutePath(List.of(START, END), List.of(0));
        RouteProfile profile = new RouteProfile(List.of(
                new RoutePoint(0, 0, START, 30, 0, 0, true), new RoutePoint(30, 300, END, 30, 0, searched, true)));
        return new SectorRoute(
                0,
                new WeakestRoute(path, searched, 0, 30),
                profile,
                bySensor,
                RouteCauses.NONE,
                Optional.of(new FlownExposure(flown, bySensor)));
    }

    static SectorRoute withAlert(SectorRoute route, double inTime) {
        return route.with(route.flown().orElseThrow().withAlertInTime(OptionalDouble.of(inTime)));
    }

    RouteResults results(SectorRoute route) {
        return results(List.of(route));
    }

    RouteResults results(List<SectorRoute> routes) {
        RouteSurvey survey = new RouteSurvey(
                routes, List.of(new RouteMode("powered", 10, 3, 3, Double.POSITIVE_INFINITY)), END, 15.0, true);
        TimeToGo times = null;
        return new RouteResults(survey, routes, new UnseenPlaces(4000, 0), times, Map.of(), true);
    }

    static FlownExposure.Step look(double time, double exposure) {
        return new FlownExposure.Step(time - 5.0, time, exposure);
    }

    static RouteResults proven(RouteResults kept, RouteProof proof) {
        return new RouteResults(
                kept.survey(), kept.found(), kept.between(), kept.times(), Map.of(0, proof), kept.isComplete());
    }
}
