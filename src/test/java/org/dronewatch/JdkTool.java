package org.dronewatch;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * A tool of the JDK in a process of its own. That ends before the code of the optimising compiler pays, so it goes
 * without, which halves the processor time.
 */
public final class JdkTool {
    /** The code of the library. */
    public static final Path SOURCES = Path.of("src", "main", "java");

    private JdkTool() {}

    /** What a tool left behind: its exit code and all that it printed. */
    public record Outcome(int code, String messages) {}

    /**
     * Runs a tool to its end, with the tests' class path.
     *
     * @param name of the program, such as {@code javac}
     * @param directory for files that it needs meanwhile
     * @param options without the class path
     * @param sources files that it reads
     */
    public static Outcome run(String name, Path directory, List<String> options, List<Path> sources)
            throws IOException, InterruptedException {
        List<String> arguments = new ArrayList<>(options);
        arguments.addAll(List.of("-cp", System.getProperty("java.class.path")));
        sources.forEach(source -> arguments.add(source.toString()));
        // So many names may be too long for a command line.
        Path file = directory.resolve(name + ".arguments");
        Files.write(file, arguments.stream().map(JdkTool::quoted).toList());
        File messages = directory.resolve(name + ".messages").toFile();
        int code = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", name).toString(),
                        "-J-XX:TieredStopAtLevel=1",
                        "-J-XX:+UseSerialGC",
                        "-J-Duser.language=en",
                        "@" + file)
                .redirectErrorStream(true)
                .redirectOutput(messages)
                .start()
                .waitFor();
        return new Outcome(code, Files.readString(messages.toPath()));
    }

    /** All Java files of a directory and those below it. */
    public static List<Path> javaFiles(Path top) throws IOException {
        try (Stream<Path> files = Files.walk(top)) {
            return files.filter(file -> file.toString().endsWith(".java")).toList();
        }
    }

    private static String quoted(String argument) {
        return '"' + argument.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
    }
}
