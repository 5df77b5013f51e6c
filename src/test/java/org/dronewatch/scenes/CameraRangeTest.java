package org.dronewatch.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.dronewatch.Thorough;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.models.Mesh;
import org.dronewatch.models.ModelCatalogue;
import org.dronewatch.models.Point;
import org.dronewatch.models.ProjectedArea;
import org.dronewatch.run.PairResult;
import org.dronewatch.run.SceneResult;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.camera.CameraSensor;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.world.World;
import org.jogamp.vecmath.Vector3d;
import org.junit.jupiter.api.Test;

class CameraRangeTest {
    private static final int RUNS = 5;
    private static final double STEP = 0.5;

    /** Ranges of first detection when the scene was made, m: they change only with the model or the scene. */
    private static final double[] RANGES = {145.0, 119.5, 93.5, 67.0, 38.5};

    private static final double FRONT = ProjectedArea.area(ModelCatalogue.QUADROTOR.mesh(), ProjectedArea.View.FRONT);

    private final SceneRunner runner = new SceneRunner(new CameraRange());

    private static CameraSettings camera(SceneSettings settings) {
        return (CameraSettings) settings.sensors().get("camera");
    }

    @Test
    void theRangesAreWhatTheyWere() {
        SceneResult result = new CameraRange().run();

        for (int run = 0; run < RUNS; run++) {
            assertThat(result.firstDetectionRange(run, "camera", "quadrotor").orElseThrow())
                    .isCloseTo(RANGES[run], within(1e-9));
        }
    }

    /**
     * Thin arms alias, so the first detection scatters about the mean-range formula; but with the same picture for all
     * five.
     */
    @Test
    void theRangesFollowTheFocalLengthAndTheMeanLaw() {
        SceneResult result = runner.run();
        double least = Double.POSITIVE_INFINITY;
        double most = 0.0;
        double widestStep = 0.0;
        for (PairResult pair : result.pairs()) {
            double f = camera(result.runs().get(pair.run()).settings()).focalLength();
            double ratio = pair.range().orElseThrow() / f;
            least = Math.min(least, ratio);
            most = Math.max(most, ratio);
            widestStep = Math.max(widestStep, STEP / f);
            assertThat(ratio / Math.sqrt(CameraRange.FRONTAL_AREA / 12.0)).isBetween(0.8, 1.55);
        }
        assertThat(most - least).isLessThanOrEqualTo(widestStep);
    }

    @Test
    void theFrontalAreaIsTheModels() {
        assertThat(CameraRange.FRONTAL_AREA).isCloseTo(FRONT, within(5e-5));
    }

    /**
     * Over random offsets within a pixel the mean number of pixels is A (f/d)^2. At the ranges of the scene A is the
     * silhouette from afar; nearer, front and rear motors no longer cover each other, so A is taken from there.
     */
    @Test
    void theMeanPixelCountFollowsTheSilhouette() {
        assertMeanCount(145.0, FRONT);
        assertMeanCount(100.0, FRONT);
        assertMeanCount(40.0, silhouetteFrom(40.0));
        assertMeanCount(15.0, silhouetteFrom(15.0));
    }

    private void assertMeanCount(double distance, double area) {
        long seed = 4711;
        SplittableRandom random = new SplittableRandom(seed);
        World farGround =
                World.of(TriangleMesh.of(new float[] {0, -9, -900, 1, -9, -900, 0, -8, -900}, new int[] {0, 1, 2}));
        Drone drone = runner.stage(runner.settings()).dronesAt(0.0).get(0);
        CameraSensor camera = CameraSettings.at(new Position(0, 0, 0))
                .withLookAt(new Position(0, 1, 0))
                .withVerticalFov(Math.PI / 6)
                .create();
        double f = camera.camera().focalLength();
        int samples = 1000;
        double sum = 0.0;
        double squares = 0.0;
        for (int i = 0; i < samples; i++) {
            double right = (random.nextDouble() - 0.5) * distance / f;
            double up = (random.nextDouble() - 0.5) * distance / f;
            Vector3d place = new Vector3d(right, distance, up);
            place.sub(drone.position());
            int pixels = camera.pixels(farGround, drone.move(place));
            sum += pixels;
            squares += (double) pixels * pixels;
        }
        double mean = sum / samples;
        double error = Math.sqrt((squares / samples - mean * mean) / (samples - 1));
        double expected = area * f * f / (distance * distance);
        assertThat(Math.abs(mean - expected))
                .as("mean %f, expected %f, standard error %f at %f m, seed %d", mean, expected, error, distance, seed)
                .isLessThan(0.01 * expected)
                .isLessThan(3.0 * error);
    }

    /** The silhouette from before the nose at a distance, on a plane through the drone's origin. */
    private static double silhouetteFrom(double distance) {
        Mesh mesh = ModelCatalogue.QUADROTOR.mesh();
        List<Point> projected = mesh.vertices().stream()
                .map(p -> new Point(p.x() * distance / (distance + p.z()), p.y() * distance / (distance + p.z()), 0))
                .toList();
        return ProjectedArea.area(new Mesh("projected", 6, projected, mesh.parts()), ProjectedArea.View.FRONT);
    }

    /** The whole flight in a smaller picture, and the frames that decide in the full one. */
    @Thorough
    @Test
    void theFirstDetectionIsThatOfTracingEveryPixel() {
        runner.set("sensors.camera.width", "320").set("sensors.camera.height", "180");
        SceneResult small = runner.run();
        List<Double> expected = new ArrayList<>();
        for (SceneSettings settings : runner.settingsOfRuns()) {
            expected.add(firstByEveryPixel(settings));
        }
        assertThat(small.pairs()).extracting(pair -> pair.range().orElse(-1)).isEqualTo(expected);

        SceneRunner full = new SceneRunner(new CameraRange());
        SceneResult result = full.run();
        for (PairResult pair : result.pairs()) {
            SceneSettings settings = result.runs().get(pair.run()).settings();
            Stage stage = full.stage(settings);
            CameraObject camera = new CameraObject(camera(settings));
            double first = pair.firstDetected().orElseThrow();
            assertThat(pixels(camera, stage, first)).isGreaterThanOrEqualTo(12);
            assertThat(pixels(camera, stage, first - 0.1)).isLessThan(12);
        }
    }

    private static int pixels(CameraObject camera, Stage stage, double time) {
        return EveryPixel.count(camera, stage.world(), stage.dronesAt(time).get(0));
    }

    private double firstByEveryPixel(SceneSettings settings) {
        Stage stage = runner.stage(settings);
        CameraObject camera = new CameraObject(camera(settings));
        for (int sample = 0; sample <= 390; sample++) {
            if (pixels(camera, stage, sample / 10.0) >= 12) {
                Drone drone = stage.dronesAt(sample / 10.0).get(0);
                return drone.distance(camera.position());
            }
        }
        return -1;
    }
}
