package org.dronewatch.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.render.Yard;
import org.dronewatch.render.photo.ColourCamera;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.sensor.optics.DepthImage;
import org.dronewatch.sensor.optics.DronePixels;
import org.dronewatch.viewer.run.PairReading;
import org.dronewatch.viewer.run.Recording;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CameraVisualTest {
    @TempDir
    private Path directory;

    private Stage stage;
    private CameraSettings settings;
    private CameraEye eye;

    @BeforeEach
    void look() {
        Yard yard = new Yard(directory);
        stage = yard.stage();
        SceneSettings all = yard.settings();
        settings = (CameraSettings) all.sensors().get("camera");
        eye = new CameraEye("camera", settings, stage, time -> Optional.empty());
    }

    private BufferedImage painted(CameraVisual visual, CameraShot shot, int width, int height) {
        visual.setSize(width, height);
        visual.show(shot);
        return Exports.picture(visual);
    }

    @Test
    void aProgramOfOnesOwnShowsACamera() {
        CameraVisual visual = CameraVisual.of("camera", settings, stage);
        visual.setSize(320, 240);
        visual.showTime(8.0);
        BufferedImage image = Exports.picture(visual);
        BufferedImage same = painted(new CameraVisual(eye), eye.look(8.0, 320, 240), 320, 240);

        for (int row = 0; row < 240; row++) {
            for (int column = 0; column < 320; column++) {
                assertThat(image.getRGB(column, row)).isEqualTo(same.getRGB(column, row));
            }
        }
        assertThatIllegalArgumentException()
                .isThrownBy(() -> CameraVisual.of("ear", AcousticSettings.at(new Position(0, 0, 2)), stage))
                .withMessage("sensor 'ear' of kind acoustic takes no images");
    }

    /** In colour, a panel of the camera's size shows what it photographs: the drone is not orange, but framed. */
    @Test
    void theSwitchToColourShowsWhatTheCameraPhotographs() {
        CameraShot blue = eye.look(8.0, 320, 240);
        eye.showColour(true);
        CameraShot colour = eye.look(8.0, 320, 240);
        BufferedImage photo =
                new ColourCamera(new CameraObject(settings), stage, ColourCamera.SAMPLES).picture(stage.dronesAt(8.0));
        BufferedImage shown = painted(new CameraVisual(eye), colour, 320, 240);
        DronePixels hits = colour.drones().get(0);
        int same = 0;
        for (int row = 0; row < 240; row++) {
            for (int column = 0; column < 320; column++) {
                assertThat(colour.background().getRGB(column, row)).isEqualTo(photo.getRGB(column, row));
                if (hits.isHit(column, row)) {
                    assertThat(shown.getRGB(column, row) & 0xffffff).isNotEqualTo(CameraVisual.HIT.getRGB() & 0xffffff);
                    same += shown.getRGB(column, row) == photo.getRGB(column, row) ? 1 : 0;
                }
            }
        }
        assertThat(same).isGreaterThan(hits.count() / 2);
        eye.showColour(false);
        assertThat(eye.look(8.0, 320, 240).background().getRGB(160, 200))
                .isEqualTo(blue.background().getRGB(160, 200));
    }

    @Test
    void aDepthImageIsShownWithoutDistortion() {
        DepthImage image = settings.create().depthImage(stage.world(), stage.dronesAt(8.0));
        DepthImageFrame.Canvas canvas = new DepthImageFrame.Canvas();
        BufferedImage picture = image.toImage();
        canvas.show(picture);
        assertThat(canvas.getPreferredSize()).isEqualTo(new Dimension(image.width(), image.height()));
        canvas.setSize(2 * image.width() + 100, 2 * image.height());
        BufferedImage shown = Exports.picture(canvas);

        for (int row = 0; row < image.height(); row++) {
            for (int column = 0; column < image.width(); column++) {
                assertThat(shown.getRGB(50 + 2 * column, 2 * row))
                        .as("pixel %d, %d", column, row)
                        .isEqualTo(picture.getRGB(column, row));
            }
        }
    }

    @Test
    void hitsAreHighlightedWhereTheCameraSeesTheDrone() {
        CameraShot shot = eye.look(8.0, 640, 480);
        DronePixels drone = shot.drones().get(0);
        BufferedImage image = painted(new CameraVisual(eye), shot, 640, 480);
        DepthImage picture = settings.create().depthImage(stage.world(), stage.dronesAt(8.0));

        assertThat(drone.count()).isGreaterThan(40).isEqualTo(picture.hitCount());
        int highlighted = 0;
        // Without the frame, its text and the magnifier.
        for (int row = drone.top() + 1; row < drone.top() + drone.rows() - 1; row++) {
            for (int column = drone.left() + 1; column < drone.left() + drone.columns() - 1; column++) {
                assertThat(drone.isHit(column, row)).isEqualTo(picture.isHit(column, row));
                boolean orange = image.getRGB(2 * column + 1, 2 * row + 1) == CameraVisual.HIT.getRGB();
                assertThat(orange).as("pixel %d, %d", column, row).isEqualTo(drone.isHit(column, row));
                highlighted += orange ? 1 : 0;
            }
        }
        assertThat(highlighted).isPositive();
    }

    @Test
    void aCameraOnAMountShowsWhereItPointsAndWhomItFollows() {
        Direction away = new Direction(Math.PI, 0.0);
        Pointing searching = Pointing.still(away, settings.fov(), OptionalInt.empty());
        Direction there =
                Direction.of(Position.of(stage.dronesAt(8.0).get(0).position()).minus(settings.position()));
        Pointing following = Pointing.still(there, Math.toRadians(10), OptionalInt.of(1));
        CameraEye turning =
                new CameraEye("eye", settings, stage, time -> Optional.of(time < 4.0 ? searching : following));
        CameraVisual visual = new CameraVisual(turning);

        CameraShot before = turning.look(3.0, 320, 240);
        visual.show(before);
        assertThat(before.drones().get(0).count()).isZero();
        assertThat(visual.name()).startsWith("eye: searches, ");
        CameraShot after = turning.look(8.0, 320, 240);
        visual.show(after);
        assertThat(visual.name()).isEqualTo("eye: follows contact 1, 10.0\u00b0");
        // Narrower, and in its middle.
        DronePixels drone = after.drones().get(0);
        assertThat(drone.count())
                .isGreaterThan(3 * eye.look(8.0, 320, 240).drones().get(0).count());
        assertThat(drone.left() + 0.5 * drone.columns()).isBetween(0.4 * settings.width(), 0.6 * settings.width());
    }

    @Test
    void significantPixelsAreFramedInTheColourOfTheDecision() {
        CameraShot near = eye.look(8.0, 320, 240);
        CameraVisual visual = new CameraVisual(eye);
        visual.mark(Map.of("quadrotor", new PairReading(8.0, 295, 12, "px", 5.1)), false);
        BufferedImage image = painted(visual, near, 320, 240);
        DronePixels drone = near.drones().get(0);
        Color left = new Color(image.getRGB(drone.left() - 1, drone.top() + drone.rows() / 2));

        assertThat(drone.count()).isGreaterThanOrEqualTo(12);
        assertThat(left.getRed()).isGreaterThan(200);
        assertThat(left.getBlue()).as("amber").isLessThan(170);
    }

    @Test
    void nearerIsDarkerAndTheSkyIsDistinct() {
        CameraShot shot = eye.look(0.0, 320, 240);
        BufferedImage image = painted(new CameraVisual(eye), shot, 320, 240);

        DepthImage picture = settings.create().depthImage(stage.world(), stage.dronesAt(0.0));
        // Up the wall and away over the lawn beside it.
        int[][] places = {{160, 180}, {160, 120}, {300, 236}, {300, 215}};
        for (int[] a : places) {
            for (int[] b : places) {
                if (picture.distance(a[0], a[1]) < 0.98 * picture.distance(b[0], b[1])) {
                    Color nearer = new Color(image.getRGB(a[0], a[1]));
                    Color farther = new Color(image.getRGB(b[0], b[1]));
                    assertThat(nearer.getRed()).isLessThan(farther.getRed());
                    assertThat(nearer.getBlue()).isGreaterThan(nearer.getRed());
                }
            }
        }
        assertThat(picture.distance(300, 236)).isNotCloseTo(picture.distance(300, 215), within(0.5f));
        Color sky = new Color(image.getRGB(300, 10));
        assertThat(sky.getRed()).isGreaterThan(240);
        assertThat(sky.getBlue()).isLessThan(sky.getRed());
    }

    @Test
    void thePixelUnderThePointerTellsWhatItShows() {
        CameraShot shot = eye.look(8.0, 320, 240);
        DronePixels drone = shot.drones().get(0);
        int hitColumn = 0;
        int hitRow = 0;
        for (int row = drone.top(); row < drone.top() + drone.rows(); row++) {
            for (int column = drone.left(); column < drone.left() + drone.columns(); column++) {
                if (drone.isHit(column, row)) {
                    hitColumn = column;
                    hitRow = row;
                }
            }
        }
        assertThat(eye.describe(shot, hitColumn, hitRow)).startsWith("quadrotor, ");
        assertThat(eye.describe(shot, 160, 190)).startsWith("brick, 15.");
        assertThat(eye.describe(shot, 300, 239)).startsWith("lawn, ");
        assertThat(eye.describe(shot, 20, 10)).isEqualTo("sky");
    }

    @Test
    void thePictureIsTheLastFrameOfTheCameraWithTheCountThatItTold() {
        Recording recording = new Recording();
        new SceneRunner(new Yard(directory)).listener(recording).run();
        for (double time = 0.05; time < 9.0; time += 0.333) {
            CameraShot shot = eye.look(time, 160, 120);
            PairReading told =
                    recording.runs().get(0).reading("camera", "quadrotor", time).orElseThrow();
            assertThat(shot.time()).isCloseTo(told.time(), within(1e-9));
            assertThat(shot.drones().get(0).count()).isEqualTo((int) told.value());
        }
    }

    @Test
    void aPictureKeepsTheProportionOfItsCamera() {
        CameraVisual visual = new CameraVisual(eye);
        visual.setSize(1000, 240);
        assertThat(visual.frame()).isEqualTo(new Rectangle(340, 0, 320, 240));
        visual.setSize(320, 1000);
        assertThat(visual.frame()).isEqualTo(new Rectangle(0, 380, 320, 240));
    }
}
