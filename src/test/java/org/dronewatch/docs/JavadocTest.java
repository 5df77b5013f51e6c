package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import org.dronewatch.JdkTool;
import org.dronewatch.LongForm;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/**
 * The API documentation can be written, and there is nothing to warn of: no reference that leads nowhere, no broken
 * HTML. The build itself cannot say so of warnings, since it names an incubating module, which always is one.
 */
@Execution(ExecutionMode.CONCURRENT)
class JavadocTest {
    @TempDir
    private Path directory;

    /** Where a file and a line are named; the first line of each complaint. */
    private static final Pattern COMPLAINT = Pattern.compile("(.*\\.java:\\d+: )?(warning|error): .*");

    private List<String> complaints(List<Path> sources) throws IOException, InterruptedException {
        List<String> options = List.of(
                "-quiet",
                "-protected",
                "-Xdoclint:all,-missing",
                "--add-modules",
                "jdk.incubator.vector",
                "-d",
                directory.resolve("api").toString());
        JdkTool.Outcome outcome = JdkTool.run("javadoc", directory, options, sources);
        List<String> complaints = outcome.messages()
                .lines()
                .filter(line -> COMPLAINT.matcher(line).matches())
                .filter(line -> !line.contains("incubating module"))
                .toList();
        assertThat(outcome.code() == 0 || !complaints.isEmpty())
                .as(outcome.messages())
                .isTrue();
        return complaints;
    }

    /**
     * In the build, {@link org.dronewatch.LintTest} finds broken references and HTML: the compiler checks comments on
     * the way.
     */
    @Test
    void thereIsNothingToWarnOf() throws IOException, InterruptedException {
        assumeTrue(LongForm.IS_ON, "the long form, which the CI runs");
        assertThat(complaints(JdkTool.javaFiles(JdkTool.SOURCES))).isEmpty();
        assertThat(directory.resolve("api/org/dronewatch/scene/Scene.html")).exists();
    }

    @Test
    void brokenHtmlIsFound() throws IOException, InterruptedException {
        Path source = directory.resolve("Odd.java");
        Files.writeString(source, "/** First. <p></p> Then <b>more. */\npublic class Odd {}\n");
        assertThat(complaints(List.of(source))).anyMatch(line -> line.contains("<p>"));
    }
}
