package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.Thorough;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A drone's own spectrum in scene files and on the command line, heard by the energy model. */
class OwnSoundRunTest {
    private static final String SCENE =
            """
            world:
              models: [packaged:house.obj]
            drones:
              buzzer:
                model: packaged:quadrotor.obj
                flight: {kind: hover, position: [0, 60, 20], heading: 0}
                %s
            sensors:
              ear:
                kind: acoustic
                position: [0, 20, 2]
                propagation: {kind: energy-model, rays: 500}
            run: {duration: 0.4 s}
            """;

    @TempDir
    private Path directory;

    private final StringWriter said = new StringWriter();

    private int run(String sound, Path out, String... options) throws IOException {
        Path file = directory.resolve("scene.yaml");
        Files.writeString(file, SCENE.formatted(sound));
        List<String> words =
                new ArrayList<>(List.of("run", file.toString(), "--observations", "--out", out.toString()));
        words.addAll(List.of(options));
        PrintWriter writer = new PrintWriter(said);
        said.getBuffer().setLength(0);
        return Main.execute(writer, writer, words.toArray(String[]::new));
    }

    private String observations(String sound, String... options) throws IOException {
        Path out = directory.resolve("out");
        assertThat(run(sound, out, options)).as("%s", said).isZero();
        return Files.readString(out.resolve("observations.csv"));
    }

    @Thorough
    @Test
    void theFiguresOfTheTableWrittenOutSoundLikeItsName() throws IOException {
        String packaged = observations("sound: c1-quadrotor");
        assertThat(observations("sound: mine\n    spectrum: [-60, -60, 0, 0, 0, 0, 0, 0]"))
                .isEqualTo(packaged);
        assertThat(observations("sound: c1-quadrotor", "--set", "drones.buzzer.spectrum=-60, -60, 0, 0, 0, 0, 0, 0"))
                .isEqualTo(packaged);
        assertThat(observations("spectrum: [0, -60, -60, -60, -60, -60, -60, -60]"))
                .isNotEqualTo(packaged);
    }

    /** A sound that is stated twice. */
    @Test
    void aSoundOfTheTableBesideASpectrumIsRefused() throws IOException {
        String own = "spectrum: [0, -60, -60, -60, -60, -60, -60, -60]";
        String refusal = "drones.buzzer: spectrum and sound 'petrol-fixed-wing' are mutually exclusive, since the"
                + " library's table has a spectrum of that name: omit one of them";
        assertThat(run(own + "\n    sound: petrol-fixed-wing", directory.resolve("both")))
                .isEqualTo(2);
        assertThat(said.toString().lines()).singleElement().asString().endsWith(refusal);
        assertThat(run(own, directory.resolve("set"), "--set", "drones.buzzer.sound=petrol-fixed-wing"))
                .isEqualTo(2);
        assertThat(said.toString().lines()).last().asString().contains("are mutually exclusive");
        assertThat(directory.resolve("both")).doesNotExist();
    }

    @Test
    void aSpectrumThatDoesNotFitIsOneLine() throws IOException {
        assertThat(run("spectrum: [0, -3, -6]", directory.resolve("a"))).isEqualTo(2);
        assertThat(said.toString().lines())
                .singleElement()
                .asString()
                .contains("scene.yaml:7", "drones.buzzer.spectrum", "must have 8");
        assertThat(run("sound: mine", directory.resolve("b"))).isEqualTo(2);
        assertThat(said.toString().lines()).singleElement().asString().contains("unknown drone sound 'mine'");
        assertThat(run("", directory.resolve("c"), "--set", "drones.buzzer.spectrum.hz125=3"))
                .isEqualTo(2);
        assertThat(said.toString().lines()).singleElement().asString().contains("spectrum");
        assertThat(run("spectrum: [0, 0, 0, 300, 0, 0, 0, 0]", directory.resolve("d")))
                .isEqualTo(2);
        assertThat(said.toString().lines()).singleElement().asString().contains("300", "-200 to 200");
        assertThat(directory.resolve("a")).doesNotExist();
    }
}
