package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.stream.Stream;
import javax.tools.ToolProvider;

/** A project of somebody else that adds kinds; its jar is made here as Maven would make it. */
final class ForeignProject {
    static final Path DIRECTORY = Path.of("src/test/resources/foreign-project");

    private ForeignProject() {}

    /** Compiles the project into a jar in a directory. */
    static Path jar(Path built) throws IOException {
        Path classes = Files.createDirectories(built.resolve("classes"));
        try (Stream<Path> sources = Files.walk(DIRECTORY.resolve("src/main/java"))) {
            Stream<String> options =
                    Stream.of("-d", classes.toString(), "-proc:none", "-cp", System.getProperty("java.class.path"));
            Stream<String> files = sources.map(Path::toString).filter(file -> file.endsWith(".java"));
            int failed = ToolProvider.getSystemJavaCompiler()
                    .run(null, null, null, Stream.concat(options, files).toArray(String[]::new));
            assertThat(failed).isZero();
        }
        Path jar = built.resolve("watch.jar");
        write(jar, List.of(classes, DIRECTORY.resolve("src/main/resources")));
        return jar;
    }

    /** Writes a jar of all files below some directories. */
    static void write(Path target, List<Path> directories) throws IOException {
        try (OutputStream bytes = Files.newOutputStream(target);
                JarOutputStream out = new JarOutputStream(bytes)) {
            for (Path root : directories) {
                try (Stream<Path> files = Files.walk(root)) {
                    for (Path file : files.filter(Files::isRegularFile).toList()) {
                        out.putNextEntry(
                                new JarEntry(root.relativize(file).toString().replace(File.separatorChar, '/')));
                        Files.copy(file, out);
                    }
                }
            }
        }
    }

    /** Copies the project's scene with its model into a directory. */
    static void copyScene(Path directory) throws IOException {
        for (String file : List.of("scene.yaml", "wall.off")) {
            Files.copy(DIRECTORY.resolve(file), directory.resolve(file));
        }
    }
}
