package org.dronewatch.app.option;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.dronewatch.app.Program;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Paths that users give on the command line. */
class PathWordTest {
    /** Java would take it for the current directory, and a run would leave its files there. */
    @ParameterizedTest
    @ValueSource(strings = {"run", "coverage", "route"})
    void anEmptyDirectoryIsRefused(String command) {
        Outcome outcome = Program.run(command, "camera-range", "--out=");

        assertThat(outcome.code()).as(outcome.err()).isEqualTo(2);
        assertThat(outcome.complaints()).containsExactly("--out '': the path is empty");
    }

    @Test
    void aPathThatNoSystemHasIsRefused() {
        assertThatThrownBy(() -> PathWord.of("--out", "a\0b"))
                .isInstanceOf(InputException.class)
                .hasMessageStartingWith("--out a\\u0000b: not a path: ");
    }
}
