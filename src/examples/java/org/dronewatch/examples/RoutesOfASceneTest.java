package org.dronewatch.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.RouteFlight;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.SiteRoutes;
import org.dronewatch.route.proof.RouteProof;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.world.Ground;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A lookout in the middle of a plain, who looks every ten seconds, and what is to be protected around him. */
class RoutesOfASceneTest {
    private static final Position EYES = new Position(0, 0, 2);
    private static final double PERIOD = 10.0;
    private static final double SPEED = 12.0;
    private static final double RADIUS = 40.0;

    @TempDir
    private Path directory;

    private RoutesOfAScene searched;

    @BeforeEach
    void load() throws IOException {
        Files.writeString(
                directory.resolve("plain.obj"),
                "v -500 0 -500\nv 500 0 -500\nv 500 0 500\nv -500 0 500\nf 1 4 3\nf 1 3 2\n");
        Path file = directory.resolve("plain.yaml");
        Files.writeString(
                file,
                """
                world: {models: [{file: plain.obj, role: terrain}]}
                drones:
                  intruder:
                    model: packaged:quadrotor.obj
                    flight: {kind: hover, position: [0, 300, 30]}
                    speed: 12 m/s
                alert: {protect: {centre: [0, 0, 30], radius: 40 m}}
                sensors:
                  eye: {kind: camera, position: [0, 0, 2]}
                run: {duration: 1 s, seed: 7}
                """);
        SceneRunner runner = new SceneRunner(new SceneFile(file));
        SceneSettings settings = runner.settings().withSensor("eye", new LookoutSettings(EYES, 1.0 / PERIOD));
        searched = new RoutesOfAScene(runner, settings, "intruder");
    }

    private SiteRoutes routes() {
        return searched.search(new FieldGrid(0.0, 0.0, 400.0, 20.0, List.of(30.0)));
    }

    /**
     * The rate is -f ln(1 - p) with p = exp(-d / 300 m) at the distance d: its integral along a straight line from the
     * centres of the outermost cells to the zone. The search finds nothing less exposed, and nearly that.
     */
    @Test
    void theExposureFromEachSideIsThatOfAStraightFlight() {
        SiteRoutes routes = routes();
        double expected = 0.0;
        double from = 190.0;
        double to = RADIUS;
        int steps = 1000;
        for (int i = 0; i < steps; i++) {
            double ground = to + (from - to) * (i + 0.5) / steps;
            double distance = Math.hypot(ground, 28.0);
            expected -= Math.log(1.0 - Math.exp(-distance / 300.0)) / PERIOD * (from - to) / steps / SPEED;
        }
        assertThat(expected).isBetween(0.5, 2.0);
        for (int sector = 0; sector < SiteRoutes.SECTORS; sector += 2) {
            WeakestRoute route = routes.from(sector).orElseThrow();
            assertThat(route.exposure()).as("sector %d", sector).isBetween(0.99 * expected, 1.03 * expected);
            assertThat(route.lower()).isBetween(0.5 * expected, expected);
            assertThat(routes.bySensor(route).get("eye")).isCloseTo(route.exposure(), within(1e-9));
        }
        for (int sector = 1; sector < SiteRoutes.SECTORS; sector += 2) {
            assertThat(routes.from(sector).orElseThrow().exposure())
                    .as("from the corner in sector %d, on a longer route", sector)
                    .isBetween(1.03 * expected, 1.2 * expected);
        }
    }

    /**
     * A thousand flights, which begin at eight moments of the lookout's period in turn, detect the drone as often as
     * the product over the looks predicts.
     */
    @Test
    void theFlightsAgreeWithThePrediction() {
        System.out.println("RoutesOfASceneTest: seed 7");
        SiteRoutes routes = routes();
        WeakestRoute route = routes.from(2).orElseThrow();
        RouteFlight flight = routes.flight(route).orElseThrow();
        FlightPath path = flight.create(SPEED, 2.0, Ground.NONE);
        double expected = 0.0;
        for (int moment = 0; moment < 8; moment++) {
            double missed = 1.0;
            for (double time = (PERIOD - moment * PERIOD / 8) % PERIOD; time <= route.seconds(); time += PERIOD) {
                missed *= 1.0 - Math.exp(-path.at(time).position().distance(EYES) / 300.0);
            }
            expected += (1.0 - missed) / 8;
        }

        RouteProof proof = searched.fly(routes, route);
        assertThat(proof.predicted()).isCloseTo(expected, within(1e-6));
        assertThat(proof.predicted()).isBetween(0.2, 0.95);
        assertThat(proof.detections().of()).isEqualTo(1000);
        assertThat(proof.detection().interval().contains(expected)).isTrue();
        assertThat(proof.agrees()).isTrue();
    }
}
