package org.dronewatch.app.option;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.app.Program;
import org.dronewatch.app.Program.Outcome;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Options of {@code route}: what is wrong is named in one line, and nothing is written. */
class RouteOptionsTest {
    private static final String SENSORS = FieldSite.ROUND
            + "  radio: {kind: rf, position: [0, 5, 4], threshold: 45}\n"
            + "alert: {protect: {centre: [0, 0, 10], radius: 30}, response: 5 s}\n";

    @TempDir
    private static Path directory;

    @BeforeAll
    static void write() throws IOException {
        FieldSite.in(directory, SENSORS);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--stopped=nan|--stopped nan: must be a number",
                "--stopped=NaN|--stopped NaN: must be 0 to 1",
                "--proof=1e3|--proof 1e3: must be a whole number",
                "--proof=|--proof: must be a whole number",
                "--proof=20000000000|--proof 20000000000: must be -2147483648 to 2147483647",
                "--proof=2000000|--proof 2000000: must be 1 to 1000000",
                "--seed=x|--seed x: must be a whole number",
            })
    void statesTheOptionItsValueAndWhatItMustBe(String option, String message) {
        Outcome refused = Program.run("route", directory.resolve("site.yaml").toString(), option);

        assertThat(refused.code()).isEqualTo(2);
        assertThat(refused.complaints()).hasSize(1);
        assertThat(refused.err()).startsWith(message);
    }

    @Test
    void theFaultOfAnotherOverrideIsNotThatOfTheResponse() {
        Outcome refused = Program.run(
                "route", directory.resolve("site.yaml").toString(), "--response=5", "--set=drones.one.speed=fast");

        assertThat(refused.code()).isEqualTo(2);
        assertThat(refused.complaints()).hasSize(1);
        assertThat(refused.err()).startsWith("--set drones.one.speed=fast: ");
    }

    @Thorough
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--launch={centre: [150, 120], radius: 30}|0",
                "--launch={centre: [0, 65], radius: 3}|2",
                "--launch={centre: [0, 65]}|2",
                "--launch=nowhere|2",
                "--response=-1|2",
                "--response=5 kg|2",
                "--response=|2",
                "--response=0|0",
                "--response=100|0",
                "--heights=600|2",
                "--cell=300|2",
                "--pointing=up|2",
                "--modes=powered|0",
                "--modes=powered,glide|2",
                "--modes=slow,powered|2",
                "--modes=glide,powered|2",
                "--modes=swim|2",
                "--modes=|2",
                "--stopped=1.1|2",
                "--proof=0|2",
                "--drone=two|2",
                "--set=sensors.round.enabled=false|0",
            })
    void isRefusedInOneLineOrSearched(String option, int code) {
        String name = "option" + option.hashCode();
        Outcome other = Program.run(
                "route",
                directory.resolve("site.yaml").toString(),
                "--side=400",
                option.startsWith("--cell") ? "--seed=1" : "--cell=40",
                option.startsWith("--heights") ? "--seed=2" : "--heights=10",
                option,
                // Pictures take time.
                code == 0 ? "--threads=2" : "--out=" + directory.resolve(name));
        assertThat(other.code()).as(other.err()).isEqualTo(code);
        assertThat(other.out().contains("no detection can be in time")).isEqualTo(option.equals("--response=100"));
        if (code == 2) {
            assertThat(other.err()).doesNotContain(" : ");
            assertThat(other.complaints()).hasSize(1);
            assertThat(other.err()).doesNotContain("--set alert");
            assertThat(directory.resolve(name)).doesNotExist();
        }
    }
}
