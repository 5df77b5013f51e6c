package org.dronewatch.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** The plots of what sensors measured over the range, by their series. */
class RangePlotsTest {
    @TempDir
    private Path directory;

    private static XYChart chart(String scene, String sensor) {
        return chart(scene, sensor, Map.of());
    }

    private static XYChart chart(String scene, String sensor, Map<String, String> overrides) {
        return plot(scene, sensor, overrides).chart();
    }

    private static RangePlot plot(String scene, String sensor, Map<String, String> overrides) {
        RangePlots plots = new RangePlots();
        SceneRunner runner = new SceneRunner(new SceneFile(Path.of("scenes", scene + ".yaml")))
                .threads(1)
                .onFrame(plots::add);
        overrides.forEach(runner::set);
        SceneResult result = runner.run();
        return plots.plot(result, sensor);
    }

    private static List<String> names(XYChart chart) {
        return chart.getSeriesCollection().stream().map(XYSeries::getName).toList();
    }

    /** The noise moves the threshold, not the level: one curve, and a threshold for each noise. */
    @Test
    void runsThatMeasureTheSameAreOneCurve() {
        XYChart chart = chart("acoustic-range", "microphone");
        assertThat(names(chart))
                .containsExactly(
                        "quadrotor, 5 identical runs",
                        "threshold 45 dB, backgroundNoise 30 dB",
                        "threshold 40 dB, backgroundNoise 25 dB",
                        "threshold 35 dB, backgroundNoise 20 dB",
                        "threshold 30 dB, backgroundNoise 15 dB",
                        "threshold 25 dB, backgroundNoise 10 dB");
        assertThat(chart.getSeriesCollection().stream().map(XYSeries::getLineColor))
                .as("no two of one colour")
                .doesNotHaveDuplicates();
        assertThat(chart.getYAxisTitle()).isEqualTo("sound level [dB]");
        assertThat(chart.getStyler().getYAxisMin()).isEqualTo(20.0);
        assertThat(chart.getStyler().getYAxisMax()).isEqualTo(50.0);
    }

    /** Fields of view change the curves; the threshold is one for all. */
    @Test
    void runsThatDifferHaveCurvesOfTheirOwn() {
        XYChart chart = chart("camera-range", "camera");
        assertThat(names(chart))
                .containsExactly(
                        "quadrotor, fov 30 deg",
                        "quadrotor, fov 36 deg",
                        "quadrotor, fov 45 deg",
                        "quadrotor, fov 60 deg",
                        "quadrotor, fov 90 deg",
                        "threshold 12 px");
        assertThat(chart.getSeriesCollection().stream().map(XYSeries::getLineColor))
                .as("the threshold is grey, and nothing else is")
                .doesNotHaveDuplicates()
                .endsWith(Color.GRAY);
        assertThat(chart.getYAxisTitle()).isEqualTo("pixels of the drone [px], clipped at 120");
    }

    /** The plotting library refuses two series of a name, and the whole run would be lost. */
    @Test
    void groupsOfRunsThatAreAlikeHaveDifferentNames() throws IOException {
        assertThat(names(chartOfSweep("[30 dB, 20 dB, 30 dB, 20 dB]", "soundLevel")))
                .contains("quadrotor, soundLevel 30 dB")
                .contains("quadrotor, soundLevel 20 dB")
                .doesNotHaveDuplicates();
        assertThat(names(chartOfSweep("[40 dB, 40 dB, 40 dB, 30 dB, 30 dB, 30 dB]", "soundLevel")))
                .contains("quadrotor, 3 identical runs", "quadrotor, 3 identical runs (2)");
        assertThat(names(chartOfSweep("[50.00001 dB, 50.00002 dB]", "soundLevel")))
                .contains("quadrotor, soundLevel 50 dB", "quadrotor, soundLevel 50 dB (2)");
    }

    private XYChart chartOfSweep(String values, String setting) throws IOException {
        Path file = directory.resolve("sweep.yaml");
        Files.writeString(
                file,
                """
                world: {models: [packaged:hill.obj]}
                drones:
                  quadrotor:
                    model: packaged:quadrotor.obj
                    flight: {kind: approach, from: [0, 60, 160], to: [0, 10, 150]}
                sensors: {microphone: {kind: acoustic, position: [0, 0, 145]}}
                run: {duration: 2 s}
                sweep: {parameter: drones.quadrotor.SETTING, values: VALUES}
                """
                        .replace("SETTING", setting)
                        .replace("VALUES", values));
        RangePlots plots = new RangePlots();
        SceneRunner runner = new SceneRunner(new SceneFile(file)).threads(1).onFrame(plots::add);
        return plots.plot(runner.run(), "microphone").chart();
    }

    /** A line of no length would not be seen. */
    @Test
    void aDroneThatHoversIsAPoint() {
        assertThat(markers(chart("closed-space", "camera", Map.of("run.duration", "1 s"))))
                .containsExactly(SeriesMarkers.CIRCLE, SeriesMarkers.NONE);
        assertThat(markers(chart("hill-radar", "radar"))).containsExactly(SeriesMarkers.NONE, SeriesMarkers.NONE);
    }

    private static List<Marker> markers(XYChart chart) {
        return chart.getSeriesCollection().stream().map(XYSeries::getMarker).toList();
    }

    @Test
    void aRadarMeasuresASignalToNoiseRatio() {
        XYChart chart = chart("hill-radar", "radar");
        assertThat(names(chart)).containsExactly("quadrotor", "threshold 17.96 dB");
        assertThat(chart.getYAxisTitle()).isEqualTo("signal-to-noise ratio [dB]");
    }

    /** Behind clutter it is not the noise alone that an echo competes with, and by chance no one threshold applies. */
    @Test
    void axisAndCaptionTellWhatIsDrawn() {
        RangePlot byChance = plot("meadow", "radar", Map.of("run.duration", "30 s"));
        XYChart chart = byChance.chart();
        assertThat(chart.getYAxisTitle()).isEqualTo("signal-to-clutter-plus-noise ratio [dB]");
        assertThat(names(chart)).containsExactly("intruder");
        assertThat(byChance.caption())
                .isEqualTo("Values measured by 'radar' (radar) versus the drone's range. No threshold is drawn,"
                        + " since it differs from look to look.");
        assertThat(plot("hill-radar", "radar", Map.of()).caption())
                .isEqualTo(
                        "Values measured by 'radar' (radar) versus the drone's range, with the detection threshold.");
    }

    /** Whatever the catalogue puts in the place of the camera, the axis tells what it measures. */
    @ParameterizedTest
    @CsvSource({"sensors.camera, cooled-thermal-camera", "sensors.camera.detection, target-task"})
    void chancesAreProbabilities(String setting, String value) {
        XYChart chart = chart("camera-range", "camera", Map.of(setting, value, "run.duration", "5 s"));
        assertThat(chart.getYAxisTitle()).isEqualTo("probability");
    }
}
