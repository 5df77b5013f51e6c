package org.dronewatch.app;

import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import picocli.CommandLine;

/** The program as tests run it: here, or in a process. */
public final class Program {
    /** Where inputs are kept that once broke the program. */
    static final Path FUZZ = Path.of("src", "test", "resources", "fuzz");

    private Program() {}

    /** What a command left behind. */
    public record Outcome(int code, String out, String err) {
        /** What it said but for what it read. */
        public List<String> complaints() {
            return err.lines().filter(line -> !line.startsWith("read ")).toList();
        }
    }

    /** All commands, to be looked at. */
    public static CommandLine commands() {
        return Commands.program(new Main());
    }

    /** Runs a command in this process. */
    public static Outcome run(String... arguments) {
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        int code = Main.execute(new PrintWriter(out, true), new PrintWriter(err, true), arguments);
        return new Outcome(code, out.toString(), err.toString());
    }

    /** Starts a command in a process. */
    static Child start(Path directory, List<String> javaOptions, String... arguments) throws IOException {
        return startWith(directory, List.of(), javaOptions, arguments);
    }

    /** Starts a run in real time that lasts for minutes, and writes into {@code results}. */
    public static Child startLongRun(Path directory) throws IOException {
        String command = "run camera-range --real-time 1 --observations --set sensors.camera.fov=1 --out results";
        return start(directory, List.of("-Xmx1g", "-XX:+UseSerialGC"), command.split(" "));
    }

    /** Starts a command in a process with more jars on its class path. */
    static Child startWith(Path directory, List<Path> jars, List<String> javaOptions, String... arguments)
            throws IOException {
        return startClass(Main.class, directory, jars, javaOptions, arguments);
    }

    /** Starts a class with a main method in a process with more jars on its class path. */
    public static Child startClass(
            Class<?> main, Path directory, List<Path> jars, List<String> javaOptions, String... arguments)
            throws IOException {
        List<String> command = java(main, jars, javaOptions);
        command.addAll(List.of(arguments));
        File out = directory.resolve("out.txt").toFile();
        File err = directory.resolve("err.txt").toFile();
        Process process = new ProcessBuilder(command)
                .directory(directory.toFile())
                .redirectOutput(out)
                .redirectError(err)
                .start();
        return new Child(process, out.toPath(), err.toPath());
    }

    /** The command that starts a class with a main method, but for its arguments. */
    static List<String> java(Class<?> main, List<Path> jars, List<String> javaOptions) {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        // Short runs end before the second compiler's code pays: half the processor time.
        command.add("-XX:TieredStopAtLevel=1");
        command.addAll(javaOptions);
        List<String> classPath = new ArrayList<>(List.of(absoluteClassPath()));
        jars.forEach(jar -> classPath.add(jar.toString()));
        command.addAll(List.of("-cp", String.join(File.pathSeparator, classPath), main.getName()));
        return command;
    }

    private static String absoluteClassPath() {
        List<String> parts = new ArrayList<>();
        for (String part : System.getProperty("java.class.path").split(File.pathSeparator)) {
            parts.add(Path.of(part).toAbsolutePath().toString());
        }
        return String.join(File.pathSeparator, parts);
    }

    /** A command in a process. */
    public record Child(Process process, Path out, Path err) implements AutoCloseable {
        /** Waits until it has ended. */
        public Outcome await() throws IOException, InterruptedException {
            if (!process.waitFor(120, TimeUnit.SECONDS)) {
                throw new AssertionError("still running after two minutes: " + Files.readString(err));
            }
            return new Outcome(process.exitValue(), Files.readString(out), Files.readString(err));
        }

        @Override
        public void close() {
            process.destroyForcibly();
        }
    }
}
