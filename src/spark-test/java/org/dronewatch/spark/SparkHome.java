package org.dronewatch.spark;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.apache.spark.deploy.SparkSubmit;
import org.apache.spark.launcher.JavaModuleOptions;

/** A Spark installation that consists of links to the jars of the build, and a cluster of two processes on it. */
final class SparkHome {
    /** Jars that Spark and dronewatch both need: only those of one scope are among {@code spark.jars}. */
    private static final Pattern SHARED = Pattern.compile("(guava|failureaccess|listenablefuture|slf4j-api|gson|jsr305"
            + "|jackson-annotations|jakarta\\.annotation-api|checker-qual|error_prone_annotations|j2objc-annotations)"
            + "-[\\d.].*\\.jar");

    private final Path directory;
    private final Path more;

    /** What a command left behind. */
    record Outcome(int code, String out, String err) {}

    /**
     * Makes an installation.
     *
     * @param directory a new one
     */
    SparkHome(Path directory) throws IOException {
        this.directory = directory;
        this.more = Files.createDirectories(directory.resolve("more"));
        Path jars = Files.createDirectories(directory.resolve("jars"));
        Stream<Path> shared = paths(System.getProperty("java.class.path"))
                .filter(jar -> SHARED.matcher(jar.getFileName().toString()).matches());
        for (Path jar :
                Stream.concat(paths(System.getProperty("spark.jars")), shared).toList()) {
            Path link = jars.resolve(jar.getFileName());
            if (!Files.exists(link)) {
                Files.createSymbolicLink(link, jar);
            }
        }
    }

    private static Stream<Path> paths(String joined) {
        return Arrays.stream(joined.split(File.pathSeparator)).map(Path::of);
    }

    /** Puts a class of the tests on the class path of driver and executors, beside Spark's own. */
    void add(Class<?> type) throws IOException {
        String name = type.getName().replace('.', '/');
        Path from =
                Path.of(type.getProtectionDomain().getCodeSource().getLocation().getPath());
        Path to = more.resolve(name).getParent();
        Files.createDirectories(to);
        try (Stream<Path> classes = Files.list(from.resolve(name).getParent())) {
            for (Path one : classes.toList()) {
                if (one.getFileName().toString().matches(type.getSimpleName() + "(\\$.*)?\\.class")) {
                    Files.copy(one, to.resolve(one.getFileName()));
                }
            }
        }
    }

    /** The jar for {@code spark-submit}. */
    static Path program() {
        return Path.of(System.getProperty("spark.program"));
    }

    /**
     * Does what the script {@code spark-submit} does, on two executors with a core each.
     *
     * @param settings of Spark, as {@code name=value}
     * @param arguments of the program
     */
    Outcome submit(List<String> settings, String... arguments) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(List.of(JavaModuleOptions.defaultModuleOptions().split(" ")));
        command.addAll(List.of("-Xmx1g", "-cp", directory.resolve("jars") + "/*" + File.pathSeparator + more));
        command.addAll(List.of(SparkSubmit.class.getName(), "--master", "local-cluster[2,1,1024]"));
        command.addAll(List.of("--conf", "spark.executor.extraClassPath=" + more));
        settings.forEach(one -> command.addAll(List.of("--conf", one)));
        command.addAll(
                List.of("--class", CampaignOnSpark.class.getName(), program().toString()));
        command.addAll(List.of(arguments));
        Path out = directory.resolve("out.txt");
        Path err = directory.resolve("err.txt");
        ProcessBuilder builder = new ProcessBuilder(command)
                .directory(directory.toFile())
                .redirectOutput(out.toFile())
                .redirectError(err.toFile());
        builder.environment().put("SPARK_HOME", directory.toString());
        builder.environment().put("SPARK_SCALA_VERSION", "2.13");
        builder.environment().put("SPARK_LOCAL_IP", "127.0.0.1");
        Process process = builder.start();
        try {
            if (!process.waitFor(5, TimeUnit.MINUTES)) {
                throw new AssertionError("still running after five minutes: " + Files.readString(err));
            }
        } finally {
            process.destroyForcibly();
        }
        return new Outcome(process.exitValue(), Files.readString(out), Files.readString(err));
    }
}
