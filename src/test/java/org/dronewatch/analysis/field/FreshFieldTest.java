package org.dronewatch.analysis.field;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedOutputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.app.Program;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * What a field holds once a sensor has been taken out of it is, byte for byte, what a process that never knew of that
 * sensor computes for the scene without it.
 */
class FreshFieldTest {
    private static final FieldGrid GRID = new FieldGrid(0.7, 0.3, 180, 20, List.of(12.0, 40.0));

    @TempDir
    private Path directory;

    /** Computes the field of a scene's directory, given by the sensor that is left out, and writes it to a file. */
    public static void main(String[] directoryAndSensor) throws IOException {
        Path own = Path.of(directoryAndSensor[0]);
        FieldSite rest = FieldSite.in(own, without(directoryAndSensor[1]));
        try (DataOutputStream file =
                new DataOutputStream(new BufferedOutputStream(Files.newOutputStream(own.resolve("field"))))) {
            write(rest.field(GRID, 2), file);
        }
    }

    /** All sensors but one; what it cues is cued by another. */
    private static String without(String sensor) {
        String rest = FieldSite.ALL.replaceAll("(?m)^  " + sensor + ": .*\\R(    .*\\R)*", "");
        return rest.replace("cues: [" + sensor + "]", "cues: [notched]");
    }

    /** Everything that it states of each sensor in each cell on each course. */
    private static void write(DetectionField field, DataOutputStream to) throws IOException {
        to.writeUTF(field.sensors() + " " + field.courses());
        for (int height = 0; height < GRID.heights().size(); height++) {
            for (int cell = 0; cell < GRID.cells(); cell++) {
                int column = cell % GRID.columns();
                int row = cell / GRID.columns();
                to.writeBoolean(field.isOpen(height, column, row));
                for (int sensor = 0; sensor < field.sensors().size(); sensor++) {
                    for (int course = 0; course < field.courses().size(); course++) {
                        to.writeInt(field.step(sensor, height, column, row, course));
                        to.writeUTF(field.cause(sensor, height, column, row, course) + " "
                                + field.margin(sensor, height, column, row, course));
                    }
                }
            }
        }
    }

    @Thorough
    @ParameterizedTest
    @ValueSource(strings = {"round", "ear"})
    void theRestIsTheFieldOfASceneThatNeverHadTheSensor(String sensor) throws IOException, InterruptedException {
        Path fresh = Files.createDirectory(directory.resolve("fresh"));
        ByteArrayOutputStream left = new ByteArrayOutputStream();
        // The other process computes meanwhile.
        try (Program.Child process = Program.startClass(
                FreshFieldTest.class,
                directory,
                List.of(),
                List.of("-XX:+UseSerialGC", "-Ddronewatch.cache=off"),
                fresh.toString(),
                sensor)) {
            FieldSite all = FieldSite.in(Files.createDirectory(directory.resolve("all")), FieldSite.ALL);
            write(all.field(GRID, 2).without(sensor), new DataOutputStream(left));
            Program.Outcome outcome = process.await();
            assertThat(outcome.code()).as(outcome.err()).isZero();
        }

        assertThat(without(sensor)).isNotEqualTo(FieldSite.ALL).doesNotContain(sensor + ":");
        assertThat(fresh.resolve("field")).hasBinaryContent(left.toByteArray());
        assertThat(left.size()).isGreaterThan(100_000);
    }
}
