package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.dronewatch.Thorough;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What an alert rule costs, without a run. */
class AlarmsCommandTest {
    private static final String SCENE = "scenes/false-alarms.yaml";

    @TempDir
    private Path directory;

    /** The radar by hand: 131 range cells, 18 beams and 11 Doppler cells, at one in a million. */
    @Test
    void ratesOfSensorsAndPricesOfRules() {
        Program.Outcome outcome = Program.run("alarms", SCENE);
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.out().lines())
                .anyMatch(line -> line.matches("radar +radar +93\\.4 +0\\.03 +960 +1"))
                .anyMatch(line -> line.matches("radio +rf +2\\.00 +5\\.6e-04 +20 +10"))
                .anyMatch(line -> line.matches("1 of 1 +50\\.000% +90\\.000% +2385 per day"))
                .anyMatch(line -> line.matches("3 of 5 +50\\.000% +99\\.144% +144 per day  <- this scene"));
    }

    @Test
    void aRuleOfItsOwnIsAddedAndJointProbabilitiesHaveNoConfirmation() throws IOException {
        assertThat(changed("confirm: {hits: 3, looks: 5}", "confirm: {hits: 4, looks: 9}"))
                .containsPattern("4 of 9 .*<- this scene");
        assertThat(changed(
                        "rule: {kind: any-sensor}\n  confirm: {hits: 3, looks: 5}",
                        "rule: {kind: union-of-probabilities, probability: 0.9}"))
                .contains("false alerts: 2385 per day")
                .doesNotContain("is confirmed");
    }

    @Test
    void whatIsUnknownIsNotZero() throws IOException {
        Program.Outcome outcome = Program.run("alarms", "scenes/hill-radar.yaml");
        assertThat(outcome.out().lines())
                .anyMatch(line -> line.matches("radar +radar +unknown +- +- +-"))
                .anyMatch(line -> line.matches("1 of 1 .* unknown  <- this scene"));
        assertThat(changed("falseAlarms: {perHour: 2, cells: 20, duration: 10 s}", "rate: 1 Hz"))
                .contains("per day from radar, camera; unknown from radio");
    }

    /** The radio receiver mistakes more in rain; the number in a run of 400 s has a Poisson distribution. */
    @Thorough
    @Test
    void ratesAreThoseOfTheWeather() throws IOException {
        String[] words = {
            "falseAlarms: {perHour: 2, cells: 20, duration: 10 s}",
            "falseAlarms: {perHour: 2, cells: 20, duration: 0, weather: [{rain: 4 mm/h, perHour: 1800}]}"
        };
        assertThat(changed(words[0], words[1])).containsPattern("radio +rf +2\\.00 ");
        assertThat(changed(words[0], words[1], "--set", "world.rain=4")).containsPattern("radio +rf +1800 ");

        Path results = directory.resolve("results");
        Program.Outcome outcome = Program.run(
                "run",
                directory.resolve("changed.yaml").toString(),
                "--set",
                "world.rain=4",
                "--set",
                "run.duration=400",
                "--set",
                "sensors.camera.enabled=false",
                "--out",
                results.toString());
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(Files.readString(results.resolve("result.json")))
                .containsPattern("\"sensor\" : \"radio\",\\s+\"per_hour\" : 1800\\.0");
        long count = Files.readAllLines(results.resolve("detections.csv")).stream()
                .filter(row -> row.contains(",false,") && row.contains(",radio,"))
                .count();
        assertThat((double) count).isCloseTo(200.0, within(4.0 * Math.sqrt(200.0)));
        assertThat(Files.readString(results.resolve("report.html")))
                .contains("only if a rate is stated for these conditions");
    }

    /** What the command prints of the scene with some words replaced. */
    private String changed(String words, String others, String... options) throws IOException {
        String text = Files.readString(Path.of(SCENE));
        assertThat(text).contains(words);
        Path scene = directory.resolve("changed.yaml");
        Files.writeString(scene, text.replace(words, others));
        Program.Outcome outcome = Program.run(Stream.concat(Stream.of("alarms", scene.toString()), Stream.of(options))
                .toArray(String[]::new));
        assertThat(outcome.code()).as(outcome.err()).isZero();
        return outcome.out();
    }

    @Test
    void theProbabilityForAWantedRate() {
        Program.Outcome outcome = Program.run("alarms", SCENE, "--sensor", "radar", "--per-hour", "20");
        assertThat(outcome.out().strip()).matches("sensors\\.radar\\.detection\\.falseAlarm=2\\.14\\de-07");
        Program.Outcome set =
                Program.run("alarms", SCENE, "--set", outcome.out().strip());
        assertThat(set.out().lines()).anyMatch(line -> line.matches("radar +radar +20\\.0 .*"));
    }

    /** What is printed, {@code --set} accepts; what it would refuse is refused here, with the limit. */
    @Test
    void noProbabilityIsPrintedThatCannotBeSet() throws IOException {
        assertError(
                "--per-hour 1e-30 needs sensors.radar.detection.falseAlarm=1.071e-38: falseAlarm 1.071e-38 must be 1e-12"
                        + " to 0.01",
                "--sensor",
                "radar",
                "--per-hour",
                "1e-30");
        assertError(
                "--per-hour 1e7 needs sensors.radar.detection.falseAlarm=", "--sensor", "radar", "--per-hour", "1e7");
        // A threshold that noise alone exceeds may be rarer than that of a radar that decides by chance.
        Path fixed = directory.resolve("fixed.yaml");
        Files.writeString(
                fixed,
                Files.readString(Path.of(SCENE))
                        .replace("detection: {kind: chance, falseAlarm: 1e-6}", "detection: fixed-threshold")
                        .replace("falseAlarms: {}", "falseAlarms: {probability: 1e-9}"));
        Program.Outcome rare = Program.run("alarms", fixed.toString(), "--sensor", "radar", "--per-hour", "1e-6");
        assertThat(rare.out()).startsWith("sensors.radar.falseAlarms.probability=1.071e-14");
    }

    @Test
    void wrongUsage() {
        assertError("--sensor and --per-hour belong together: give both or neither", "--sensor", "radar");
        assertError("--per-hour 0: must be above 0 and at most 1e7", "--sensor", "radar", "--per-hour", "0");
        assertError("--per-hour 1e9: must be above 0 and at most 1e7", "--sensor", "radar", "--per-hour", "1e9");
        assertError("--sensor nobody: no such sensor", "--sensor", "nobody", "--per-hour", "1");
        assertError(
                "--sensor camera: is of kind camera, whose rate is set, not computed",
                "--sensor",
                "camera",
                "--per-hour",
                "1");
        assertError("--run 1: must be 0", "--run", "1");
    }

    private static void assertError(String message, String... options) {
        String[] arguments = new String[options.length + 2];
        arguments[0] = "alarms";
        arguments[1] = SCENE;
        System.arraycopy(options, 0, arguments, 2, options.length);
        Program.Outcome outcome = Program.run(arguments);
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.complaints()).hasSize(1).allMatch(line -> line.startsWith(message));
    }
}
