package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import org.dronewatch.Thorough;
import org.dronewatch.app.Main;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.RadarSignature;
import org.dronewatch.drone.RadioLink;
import org.dronewatch.drone.ThreatLabel;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.run.FalseAlarmResult;
import org.dronewatch.run.RunResult;
import org.dronewatch.sensor.Observation;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Birds among drones, in scenes/birds.yaml: sensors see them like drones, and only scoring knows what they are. */
class BirdsTest {
    private static final Path SCENE = Path.of("scenes", "birds.yaml");
    private static final int RUNS = 40;
    private static final long FIRST_SEED = 500;

    @TempDir
    private Path directory;

    /** Of a run of the scene as it is. */
    private static RunResult asItIs;

    private static final List<Observation> OBSERVED = new ArrayList<>();

    @BeforeAll
    static void run() {
        asItIs = new SceneRunner(new SceneFile(SCENE))
                .threads(1)
                .onFrame(frame -> OBSERVED.addAll(frame.observations()))
                .run()
                .runs()
                .get(0);
    }

    private SceneRunner runner(String... replaced) throws IOException {
        String text = Files.readString(SCENE);
        for (int i = 0; i < replaced.length; i += 2) {
            assertThat(text).contains(replaced[i]);
            text = text.replace(replaced[i], replaced[i + 1]);
        }
        return new SceneRunner(new SceneFile(Files.writeString(directory.resolve("birds.yaml"), text))).threads(1);
    }

    private String main(String... arguments) {
        StringWriter out = new StringWriter();
        PrintWriter both = new PrintWriter(out, true);
        assertThat(Main.execute(both, both, arguments)).as(out.toString()).isZero();
        return out.toString();
    }

    @Test
    void aBirdIsAFalseAlertAndNoDrone() throws IOException {
        Path out = directory.resolve("out");
        String printed = main("run", SCENE.toString(), "--observations", "--out", out.toString());
        assertThat(printed)
                .contains("was caused by a bird: buzzard")
                .containsPattern("\\(false alarms: radar \\d+ \\(all caused by birds\\)\\)")
                .doesNotContain(" gull ");
        List<String> rows = Files.readAllLines(out.resolve("detections.csv"));
        assertThat(rows)
                .anyMatch(row -> row.contains(",false,radar,radar,buzzard,"))
                .noneMatch(row -> row.matches(".*,(gained|lost),.*,(gull|buzzard|starling.*),.*"));
        for (String row : Files.readAllLines(out.resolve("observations.csv"))) {
            assertThat(row.endsWith("bird=1")).as(row).isEqualTo(row.matches(".*,(gull|buzzard|starling-\\d+),.*"));
        }
        assertThat(Files.readString(out.resolve("result.json")))
                .containsPattern("\"birds\" : \\[ \\{\\s+\"bird\" : \"buzzard\"")
                .doesNotContain("\"drone\" : \"buzzard\"");
        assertThat(Files.readString(out.resolve("report.html")))
                .contains("raised by radar, was caused by a bird: 'buzzard'", "starling (flock of 12)")
                .contains(
                        "Every sensor detects every drone at some time. The table below states for what part of the run"
                                + " a sensor does not detect a drone, and why.")
                .containsPattern("<td>radio</td><td>rf</td><td>intruder</td><td class=\"n\">9\\d %</td>"
                        + "<td>9\\d % of the time: signal too weak; 1 % of the time: between looks</td>");
    }

    @Test
    void onlyDronesAreScored() {
        RunResult run = asItIs;
        assertThat(run.alerts()).extracting(alert -> alert.drone()).containsExactly("intruder");
        assertThat(run.pairs()).extracting(pair -> pair.drone()).containsOnly("intruder");
        assertThat(run.events()).allMatch(event -> event.observation().drone().equals("intruder"));
        assertThat(run.falseAlarms().birds().keySet()).contains("buzzard");
        assertThat(run.falseAlarms().alertCount())
                .isEqualTo(run.falseAlarms().birds().size());
        assertThat(run.settings().birds()).hasSize(14).contains("gull", "starling-12");
    }

    /** Noise and birds of one radar: the console says how many are which. */
    @Test
    void birdsAmongFalseAlarmsAreCounted() throws IOException {
        SceneRunner runner = runner(
                "detection: {kind: chance, falseAlarm: 1e-6}",
                "detection: {kind: chance, falseAlarm: 1e-6}\n    falseAlarms: {cells: 2e4}");
        Path noisy = directory.resolve("birds.yaml");
        FalseAlarmResult counted = runner.run().runs().get(0).falseAlarms();
        long all = counted.counted().get("radar");
        long birds = counted.ofBirds().get("radar");
        assertThat(birds).isBetween(1L, all - 1);
        assertThat(main(
                        "run",
                        noisy.toString(),
                        "--out",
                        directory.resolve("noisy").toString()))
                .contains("(false alarms: radar " + all + " (" + birds + " caused by birds))");
    }

    /** What is measured does not depend on the role, and a harmless drone is a drone. */
    @Test
    void noSensorKnowsABird() throws IOException {
        List<Observation> ofBirds = OBSERVED;
        List<Observation> ofDrones = new ArrayList<>();
        RunResult drones = runner("role: bird", "role: bystander")
                .onFrame(frame -> ofDrones.addAll(frame.observations()))
                .run()
                .runs()
                .get(0);
        assertThat(ofBirds).hasSameSizeAs(ofDrones).isNotEqualTo(ofDrones);
        for (int i = 0; i < ofBirds.size(); i++) {
            assertThat(ofBirds.get(i).measurements()).isEqualTo(ofDrones.get(i).measurements());
        }
        assertThat(drones.alerts()).hasSize(15);
        assertThat(drones.falseAlarms().count()).isZero();
    }

    /**
     * A bird's echo by the radar equation and Swerling's first case: 13.18 dB from 1 m2 at 1050 m, and
     * {@code Pd = Pfa^(1 / (1 + S))}.
     */
    @Test
    void itsEchoIsThatOfItsCrossSection() {
        List<Observation> gulls = OBSERVED.stream()
                .filter(one ->
                        one.drone().equals("gull") && one.sensor().equals("radar") && Double.isFinite(one.value()))
                .toList();
        assertThat(gulls).hasSizeGreaterThan(200);
        for (Observation one : gulls) {
            double expected = 13.1835 + 10.0 * Math.log10(0.0069) + 40.0 * Math.log10(1050.0 / one.range());
            double probability = Math.pow(1e-6, 1.0 / (1.0 + Math.pow(10.0, 0.1 * expected)));
            assertThat(one.value()).isCloseTo(expected, within(1e-3));
            assertThat(one.probability()).isCloseTo(probability, within(1e-4));
        }
    }

    private static double median(List<Double> values) {
        Collections.sort(values);
        return 0.5 * (values.get(values.size() / 2 - 1) + values.get(values.size() / 2));
    }

    /** The table of the page on alerts. */
    @Thorough
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "3 of 5 looks, any sensor | hits: 3 | hits: 3",
                "5 of 8 looks, any sensor | 'hits: 3, looks: 5' | 'hits: 5, looks: 8'",
                "3 of 5 looks, `minSpeed: 11 m/s` | 'detection: {kind: chance' | 'minSpeed: 11 m/s\\n    detection: {kind: chance'",
                "3 of 5 looks, radar and radio | 'kind: any-sensor' | 'kind: several-sensors, count: 2'"
            })
    void theTableOfTheAlertPage(String rule, String from, String to) throws IOException {
        System.out.println("seeds " + FIRST_SEED + " to " + (FIRST_SEED + RUNS - 1));
        SceneRunner runner = runner(from, to.replace("\\n", "\n"));
        List<Double> times = new ArrayList<>();
        int withBuzzard = 0;
        int withGull = 0;
        int flock = 0;
        for (int i = 0; i < RUNS; i++) {
            RunResult run = runner.seed(FIRST_SEED + i).run().runs().get(0);
            times.add(run.alerts().get(0).time().orElse(Double.POSITIVE_INFINITY));
            withBuzzard += run.falseAlarms().birds().containsKey("buzzard") ? 1 : 0;
            withGull += run.falseAlarms().birds().containsKey("gull") ? 1 : 0;
            flock += (int) run.falseAlarms().birds().keySet().stream()
                    .filter(bird -> bird.startsWith("starling"))
                    .count();
        }
        String row = String.format(
                Locale.ROOT,
                "| %s | %.1f s | %d | %d | %.1f |",
                rule,
                median(times),
                withBuzzard,
                withGull,
                (double) flock / RUNS);
        System.out.println(row);
        assertThat(Files.readString(Path.of("src", "site", "markdown", "alert.md")))
                .contains(row);
    }

    @Thorough
    @Test
    void labelledPicturesDistinguishBirds() throws IOException {
        runner(
                "  radio:\n",
                "  camera: {kind: camera, position: [0, 0, 146], aim: {azimuth: 0 deg, elevation: 8 deg},"
                        + " fov: 50 deg, width: 480, height: 270, rate: 1 Hz}\n  radio:\n",
                "duration: 50 s",
                "duration: 5 s");
        Path out = directory.resolve("labelled");
        main("run", directory.resolve("birds.yaml").toString(), "--labels", "camera", "--out", out.toString());
        String coco = Files.readString(out.resolve("coco.json"));
        assertThat(coco)
                .contains("{\"id\":2,\"name\":\"bird\",\"supercategory\":\"animal\"}")
                .containsPattern("\"category_id\":2,[^\\n]*\"drone\":\"buzzard\"")
                .doesNotContainPattern("\"category_id\":1,[^\\n]*\"drone\":\"buzzard\"");
    }

    @Test
    void aBirdTransmitsNothing() {
        ModelSettings model = ModelSettings.packaged("fixed-wing.obj");
        DroneSettings bird = DroneSettings.bird(model, Hover.at(new Position(0, 0, 50)), 12.0, 0.005);
        assertThat(bird.isBird()).isTrue();
        assertThat(bird.radar().fluctuation()).isEqualTo(RadarSignature.Fluctuation.SWERLING_1);
        String message =
                "label.role bird: a bird has neither a transmitter nor motors nor rotors: radio.control must be"
                        + " autonomous, soundLevel and soundPowerLevel 0, and radar.rotorLevel omitted";
        assertThatThrownBy(() -> bird.withRadio(RadioLink.DEFAULT)).hasMessage(message);
        assertThatThrownBy(() -> bird.withSoundLevel(1.0)).hasMessage(message);
        assertThatThrownBy(() -> bird.withRadar(bird.radar().withRotorLevel(20.0)))
                .hasMessage(message);
        assertThatThrownBy(() -> DroneSettings.of(model, Hover.at(new Position(0, 0, 50)))
                        .withLabel(ThreatLabel.BIRD))
                .hasMessage(message);
    }
}
