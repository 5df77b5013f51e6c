package org.dronewatch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The compiler has nothing to warn of. The build itself cannot say so: it names an incubating module, which is a warning that
 * only goes away with all others.
 */
class LintTest {
    /** They need the incubating module, and come from the build's own classes here. */
    private static final Set<String> WITH_VECTORS =
            Set.of("BvhTraversal.java", "VectorRasteriser.java", "VectorTriangleSetup.java", "VectorWidth.java");

    @TempDir
    private Path directory;

    @Test
    void theCompilerHasNothingToWarnOf() throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        StringWriter messages = new StringWriter();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, null);
                Stream<Path> sources = Files.walk(Path.of("src", "main", "java"))) {
            List<Path> checked = sources.filter(file -> file.toString().endsWith(".java"))
                    .filter(file -> !WITH_VECTORS.contains(file.getFileName().toString()))
                    .toList();
            assertThat(checked).hasSizeGreaterThan(250);
            boolean clean = compiler.getTask(
                            messages,
                            files,
                            null,
                            List.of(
                                    "-Xlint:all,-classfile",
                                    "-Werror",
                                    "-proc:none",
                                    "--release",
                                    "17",
                                    "-d",
                                    directory.toString(),
                                    "-cp",
                                    System.getProperty("java.class.path")),
                            null,
                            files.getJavaFileObjectsFromPaths(checked))
                    .call();
            assertThat(clean).as(messages.toString()).isTrue();
        }
    }
}
