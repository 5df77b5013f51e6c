package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticCollector;
import javax.tools.DocumentationTool;
import javax.tools.JavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The API documentation can be written, and there is nothing to warn of: no reference that leads nowhere, no broken
 * HTML. The build itself cannot say so of warnings, since it names an incubating module, which always is one.
 */
class JavadocTest {
    @TempDir
    private Path directory;

    private List<String> complaints(List<Path> sources) throws IOException {
        DocumentationTool javadoc = ToolProvider.getSystemDocumentationTool();
        DiagnosticCollector<JavaFileObject> heard = new DiagnosticCollector<>();
        try (StandardJavaFileManager files = javadoc.getStandardFileManager(heard, Locale.ROOT, null)) {
            boolean done = javadoc.getTask(
                            null,
                            files,
                            heard,
                            null,
                            List.of(
                                    "-quiet",
                                    "-protected",
                                    "-Xdoclint:all,-missing",
                                    "--add-modules",
                                    "jdk.incubator.vector",
                                    "-d",
                                    directory.resolve("api").toString(),
                                    "-cp",
                                    System.getProperty("java.class.path")),
                            files.getJavaFileObjectsFromPaths(sources))
                    .call();
            List<String> complaints = heard.getDiagnostics().stream()
                    .filter(said -> said.getKind() != Diagnostic.Kind.NOTE)
                    .map(said -> said.toString())
                    .filter(line -> !line.contains("incubating module"))
                    .filter(line -> !line.matches("\\d+ warnings?"))
                    .toList();
            assertThat(done || !complaints.isEmpty()).isTrue();
            return complaints;
        }
    }

    @Test
    void thereIsNothingToWarnOf() throws IOException {
        try (Stream<Path> files = Files.walk(Path.of("src", "main", "java"))) {
            List<Path> sources =
                    files.filter(file -> file.toString().endsWith(".java")).toList();
            assertThat(complaints(sources)).isEmpty();
        }
        assertThat(directory.resolve("api/org/dronewatch/scene/Scene.html")).exists();
    }

    @Test
    void aBrokenReferenceIsFound() throws IOException {
        Path source = directory.resolve("Odd.java");
        Files.writeString(source, "/** As {@link Nobody}. */\npublic class Odd {}\n");
        assertThat(complaints(List.of(source))).singleElement().asString().contains("reference not found");
    }

    @Test
    void brokenHtmlIsFound() throws IOException {
        Path source = directory.resolve("Odd.java");
        Files.writeString(source, "/** First. <p></p> Then <b>more. */\npublic class Odd {}\n");
        assertThat(complaints(List.of(source))).anyMatch(line -> line.contains("<p>"));
    }
}
