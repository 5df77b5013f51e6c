package org.dronewatch.fuzz;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Feeds all parts of the program with random input for a while, each in separate processes, and fails if a part does
 * not do what it should. Options are system properties: {@code fuzz.seconds} for all targets together,
 * {@code fuzz.seed}, {@code fuzz.targets} (names with commas), {@code fuzz.case} for a single case,
 * {@code fuzz.replay} for the directory of a reproducer.
 */
public final class Fuzz {
    private static final Path HOME = Path.of("target", "fuzz");
    private static final String HEAP = "-Xmx512m";

    private final long seed;
    private final double secondsEach;

    private Fuzz(long seed, double secondsEach) {
        this.seed = seed;
        this.secondsEach = secondsEach;
    }

    /** Runs the targets and ends the process with 1 if anything failed. */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        Optional<String> replay = option("replay");
        if (replay.isPresent()) {
            System.exit(replay(Path.of(replay.get())));
        }
        List<FuzzTarget> targets = option("targets")
                .map(names ->
                        List.of(names.split(",")).stream().map(Targets::named).toList())
                .orElseGet(Targets::all);
        double seconds = option("seconds").map(Double::parseDouble).orElse(600.0);
        long seed = option("seed").map(Long::parseLong).orElseGet(() -> System.nanoTime() & Integer.MAX_VALUE);
        Fuzz fuzz = new Fuzz(seed, seconds / targets.size());
        System.out.printf("fuzzing %d targets for %.0f s, -Dfuzz.seed=%d%n", targets.size(), seconds, seed);
        Optional<Long> single = option("case").map(Long::parseLong);
        List<String> failed = new ArrayList<>();
        for (FuzzTarget target : targets) {
            failed.addAll(fuzz.run(target, single));
        }
        failed.forEach(System.out::println);
        System.out.println(
                failed.isEmpty() ? "no failures" : failed.size() + " distinct failures, -Dfuzz.seed=" + seed);
        System.exit(failed.isEmpty() ? 0 : 1);
    }

    private static Optional<String> option(String name) {
        return Optional.ofNullable(System.getProperty("fuzz." + name)).filter(value -> !value.isBlank());
    }

    /** Runs one target until its time is up; prints a line for each distinct failure. */
    private List<String> run(FuzzTarget target, Optional<Long> single) throws IOException, InterruptedException {
        Path home = HOME.resolve(target.name());
        Scratch.delete(home);
        Files.createDirectories(home);
        long start = System.currentTimeMillis();
        long end = single.isPresent() ? Long.MAX_VALUE : start + (long) (1000 * secondsEach);
        long last = single.map(number -> number + 1).orElse(Long.MAX_VALUE);
        long next = single.orElse(0L);
        int deaths = 0;
        while (next < last && System.currentTimeMillis() < end) {
            int code = work(target, next, last, start, end, home);
            long reached = reached(home);
            if (code == 0) {
                next = reached;
                break;
            }
            if (code != FuzzWorker.HANGS) {
                died(target, reached, code, start, home, deaths++);
            }
            next = reached + 1;
        }
        List<Finding> findings = Finding.readAll(home);
        System.out.printf("%s: %d cases, %d distinct failures%n", target.name(), next, findings.size());
        return findings.stream()
                .map(finding -> String.format(
                        "FAILED %s, case %d after %.1f s: %s (%s)",
                        target.name(), finding.number(), finding.seconds(), finding.shape(), finding.directory()))
                .toList();
    }

    private int work(FuzzTarget target, long next, long last, long start, long end, Path home)
            throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                HEAP,
                "-XX:+UseSerialGC",
                "-Djava.awt.headless=true",
                "--add-modules",
                "jdk.incubator.vector",
                "-cp",
                System.getProperty("java.class.path"),
                FuzzWorker.class.getName(),
                target.name()));
        for (long number : new long[] {seed, next, last, start, end}) {
            command.add(Long.toString(number));
        }
        command.add(home.toString());
        File log = home.resolve("log.txt").toFile();
        Process process = new ProcessBuilder(command)
                .redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.appendTo(log))
                .start();
        try {
            return process.waitFor();
        } finally {
            process.destroyForcibly();
        }
    }

    private static long reached(Path home) throws IOException {
        Path progress = home.resolve(FuzzWorker.PROGRESS);
        return Files.exists(progress) ? Long.parseLong(Files.readString(progress)) : 0;
    }

    /** Reports a worker that did not end by one of its own checks: the virtual machine gave up, or was ended. */
    private void died(FuzzTarget target, long number, int code, long start, Path home, int deaths) throws IOException {
        if (deaths == 0) {
            FuzzCase input = target.generate(new Dice(Seeds.of(seed, target.name(), number)), number);
            Failure failure = new Failure("a process that goes on", "it ended with " + code + ": see log.txt");
            double seconds = 1e-3 * (System.currentTimeMillis() - start);
            new Reproducer(home, target.name(), seed).write(input, number, Failure.shapeOf(failure), failure, seconds);
        }
    }

    /** Judges a stored case in this process. */
    private static int replay(Path directory) throws IOException {
        FuzzTarget target = Targets.named(FuzzCase.properties(directory).getProperty("target"));
        FuzzCase input = FuzzCase.readFrom(directory);
        Path work = HOME.resolve("replay");
        Scratch.delete(work);
        Files.createDirectories(work);
        input.writeFiles(work);
        long start = System.nanoTime();
        Throwable problem;
        try {
            problem = new Watchdog(target).judge(input, work).orElse(null);
        } catch (Watchdog.Hang e) {
            problem = e;
        }
        double seconds = FuzzWorker.secondsSince(start);
        if (problem == null) {
            System.out.printf("passes after %.1f s%n", seconds);
            return 0;
        }
        System.out.printf("fails after %.1f s: %s%n", seconds, Messages.printable(String.valueOf(problem)));
        return 1;
    }
}
