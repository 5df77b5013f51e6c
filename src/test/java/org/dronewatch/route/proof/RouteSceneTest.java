package org.dronewatch.route.proof;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.drone.FlightPerformance;
import org.dronewatch.flight.RouteFlight;
import org.dronewatch.flight.RouteLeg;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RouteSceneTest {
    @TempDir
    private Path directory;

    /** At a corner of a right angle, a drone that turns at 6 deg/s; climbing 60 m in 10 s is no matter of corners. */
    @Test
    void theCornersOfARouteAreNoExcess() throws IOException {
        SceneSettings site = FieldSite.in(directory, FieldSite.ROUND).settings();
        SceneSettings stated = site.withDrone(
                FieldSite.DRONE,
                site.drones().get(FieldSite.DRONE).withPerformance(FlightPerformance.TYPICAL.withTurnRate(0.1)));
        RouteFlight flight = RouteFlight.of(
                new Position(100.0, 300.0, 40.0),
                List.of(
                        new RouteLeg(new Position(220.0, 300.0, 40.0), Optional.of(12.0), true),
                        new RouteLeg(new Position(220.0, 180.0, 100.0), Optional.of(12.0), true)));
        List<String> notes = new ArrayList<>();
        SceneRunner runner = new SceneRunner(new SceneFile(directory.resolve("site.yaml"))).notes(notes::add);

        runner.stage(RouteScene.of(stated, FieldSite.DRONE, flight));

        assertThat(notes).anyMatch(note -> note.contains("climbs at")).noneMatch(note -> note.contains("turns at"));
    }
}
