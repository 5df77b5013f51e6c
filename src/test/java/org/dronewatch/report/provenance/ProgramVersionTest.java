package org.dronewatch.report.provenance;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

class ProgramVersionTest {
    @Test
    void isThatOfTheBuild() throws IOException {
        Matcher version = Pattern.compile("<artifactId>dronewatch</artifactId>\\s*<version>([^<]+)</version>")
                .matcher(Files.readString(Path.of("pom.xml")));
        assertThat(version.find()).isTrue();

        assertThat(ProgramVersion.text()).isEqualTo(version.group(1));
    }

    @Test
    void aResourceThatNobodyFilledInIsNoVersion() {
        assertThat(ProgramVersion.filled("${project.version}")).isEqualTo("development");
        assertThat(ProgramVersion.filled("")).isEqualTo("development");
        assertThat(ProgramVersion.filled(" 1.2.0 ")).isEqualTo("1.2.0");
    }
}
