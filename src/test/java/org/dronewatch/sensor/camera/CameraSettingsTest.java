package org.dronewatch.sensor.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.sensor.Walls.assess;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.look;
import static org.dronewatch.sensor.Walls.open;

import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Condition;
import org.dronewatch.sensor.Discrimination;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.SensorDescription;
import org.dronewatch.sensor.Thresholded;
import org.dronewatch.setting.Quantity;
import org.junit.jupiter.api.Test;

/** What the settings of a camera state about it, by its detection function. */
class CameraSettingsTest {
    private static final CameraSettings PIXELS = CameraSettings.at(new Position(0, 0, 0));
    private static final CameraSettings TASK = PIXELS.withDetection(TargetTask.DEFAULT.withProbability(0.7));

    @Test
    void onlyACameraThatCountsPixelsHasAThresholdToFit() {
        assertThat(PIXELS.as(Thresholded.class)).hasValue(PIXELS);
        assertThat(TASK.as(Thresholded.class)).isEmpty();
        assertThat(PIXELS.as(Mounted.class)).hasValue(PIXELS);
        assertThat(TASK.as(Mounted.class)).hasValue(TASK);
    }

    /** From a single pixel, in whole pixels, to a drone that fills the image. */
    @Test
    void thresholdsToFitAreWholeNumbersOfPixelsOfTheImage() {
        Thresholded.Scale scale = PIXELS.withResolution(30, 20).thresholdScale();

        assertThat(scale.setting()).isEqualTo("detection.pixels");
        assertThat(scale.quantity()).isEqualTo(Quantity.PIXELS);
        assertThat(scale.value(0)).isEqualTo(1.0);
        assertThat(scale.value(1)).isEqualTo(2.0);
        assertThat(scale.value(scale.last())).isEqualTo(600.0);
    }

    /** The greatest threshold at which a drone is detected is the number of its pixels. */
    @Test
    void aDroneIsDetectedUpToTheThresholdOfItsPixels() {
        Drone drone = cube(new Position(0, 200, 0));
        int pixels = PIXELS.create().pixels(open(), drone);

        assertThat(PIXELS.withThreshold(pixels).detection()).isEqualTo(new PixelThreshold(pixels));
        assertThat(look(PIXELS.withThreshold(pixels), open(), drone, 1).isDetected())
                .isTrue();
        assertThat(look(PIXELS.withThreshold(pixels + 1), open(), drone, 1).isDetected())
                .isFalse();
    }

    @Test
    void aFalseAlarmIsAtTheThreshold() {
        for (CameraSettings camera : new CameraSettings[] {PIXELS, TASK}) {
            Reading reading = camera.falseReading(open(), 3.0);
            assertThat(reading.isDetected()).isTrue();
            assertThat(reading.value()).isEqualTo(camera.detection().threshold());
            assertThat(reading.unit()).isEqualTo(camera.detection().unit());
        }
        assertThat(PIXELS.falseReading(open(), 3.0)).isEqualTo(new Reading(12.0, 12.0, "px"));
        assertThat(TASK.falseReading(open(), 3.0)).isEqualTo(new Reading(0.7, 0.7, ""));
    }

    /** Weather and light matter to a task, but not to a count of pixels, which a scene's author is told. */
    @Test
    void aDescriptionSaysWhatTheDetectionFunctionLeavesOut() {
        SensorDescription counting = PIXELS.description();
        SensorDescription performing = TASK.description();

        assertThat(counting.measures()).isEqualTo("pixels of the drone");
        assertThat(counting.weakness()).isEqualTo("too small or too faint");
        assertThat(counting.leavesOut()).singleElement().asString().contains("no account of contrast, haze, light");
        assertThat(counting.ignoredConditions())
                .containsOnlyKeys(
                        Condition.VISIBILITY,
                        Condition.ILLUMINANCE,
                        Condition.SUN,
                        Condition.TURBULENCE,
                        Condition.GROUND_BRIGHTNESS,
                        Condition.RAIN);
        assertThat(counting.ignoredConditions().values()).allMatch(advice -> advice.contains("target-task"));
        assertThat(performing.measures()).isEqualTo("probability");
        assertThat(performing.weakness()).isEqualTo("too small or too faint");
        assertThat(performing.leavesOut()).singleElement().asString().contains("assumed contrast");
        assertThat(performing.ignoredConditions()).isEmpty();
    }

    @Test
    void resultsNameTheKindOfSensorAndTheUnitOfItsValue() {
        Drone drone = cube(new Position(0, 200, 0));

        assertThat(look(PIXELS, open(), drone, 1).kind()).isEqualTo("camera");
        assertThat(look(PIXELS, open(), drone, 1).unit()).isEqualTo("px");
        assertThat(assess(PIXELS, open(), drone).unit()).isEqualTo("px");
        assertThat(look(TASK, open(), drone, 1).unit()).isEmpty();
    }

    /** Without chance, the stated probability decides; with it, the threshold is an even chance. */
    @Test
    void theThresholdOfATaskIsItsProbabilityUnlessChanceDecides() {
        Drone drone = cube(new Position(0, 1000, 0));
        double exact = assess(TASK, open(), drone).quantity();
        TargetTask task = TargetTask.DEFAULT;

        assertThat(exact).isBetween(0.02, 0.98);
        assertThat(look(PIXELS.withDetection(task.withProbability(exact)), open(), drone, 1)
                        .isDetected())
                .isTrue();
        assertThat(look(PIXELS.withDetection(task.withProbability(Math.nextUp(exact))), open(), drone, 1)
                        .isDetected())
                .isFalse();
        assertThat(assess(PIXELS.withDetection(task.withProbability(0.9).withChance(true)), open(), drone)
                        .threshold())
                .isEqualTo(0.5);
    }

    /** A view's probability of detection, whatever the task: 0.75 line pairs are an even chance, at 2.25 pixels. */
    @Test
    void aDroneThatCannotBeRecognisedYetCanBeFollowed() {
        TargetTask recognition = TargetTask.DEFAULT.withTask(Discrimination.RECOGNITION);
        DroneView view = new DroneView(40, 100, 1000, 0, open().light(), Double.POSITIVE_INFINITY);

        assertThat(recognition.value(view)).isBetween(0.4, 0.6);
        assertThat(recognition.followingValue(view).orElseThrow())
                .isEqualTo(TargetTask.DEFAULT.value(view))
                .isGreaterThan(0.99);
        assertThat(PixelThreshold.DEFAULT.followingValue(view)).isEmpty();
    }
}
