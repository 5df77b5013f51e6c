package org.dronewatch.fuzz;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;

/** Runs the cases of one target, in a process with a small heap that {@link Fuzz} starts. */
public final class FuzzWorker {
    /** Exit code of a worker that found a case that does not end: it cannot continue; another worker does. */
    static final int HANGS = 3;

    /** The file in which a worker states its current case; its parent reads it if the worker dies. */
    static final String PROGRESS = "progress";

    private static final Duration LONGEST_TO_SHRINK = Duration.ofSeconds(1);
    private static final Duration SHRINKING = Duration.ofSeconds(8);
    private static final double NANO = 1e-9;

    private final FuzzTarget target;
    private final long seed;
    private final long started;
    private final Path home;
    private final Reproducer reproducer;
    private final Watchdog watchdog;
    private final Set<String> known = new HashSet<>();

    private FuzzWorker(FuzzTarget target, long seed, long started, Path home) throws IOException {
        this.target = target;
        this.seed = seed;
        this.started = started;
        this.home = home;
        this.reproducer = new Reproducer(home, target.name(), seed);
        this.watchdog = new Watchdog(target);
        for (Finding finding : Finding.readAll(home)) {
            known.add(finding.shape());
        }
    }

    /**
     * Runs cases.
     *
     * @param arguments target, seed, first case, one after the last case, start and end in milliseconds since 1970, and
     *     the directory for failures
     */
    public static void main(String[] arguments) throws IOException {
        FuzzTarget target = Targets.named(arguments[0]);
        FuzzWorker worker = new FuzzWorker(
                target, Long.parseLong(arguments[1]), Long.parseLong(arguments[4]), Path.of(arguments[6]));
        worker.run(Long.parseLong(arguments[2]), Long.parseLong(arguments[3]), Long.parseLong(arguments[5]));
        // A case may have left threads behind that keep the process alive.
        System.exit(0);
    }

    private void run(long first, long last, long end) throws IOException {
        Files.createDirectories(home);
        long number = first;
        for (; number < last && System.currentTimeMillis() < end; number++) {
            Files.writeString(home.resolve(PROGRESS), Long.toString(number));
            FuzzCase input = target.generate(new Dice(Seeds.of(seed, target.name(), number)), number);
            long start = System.nanoTime();
            Optional<Throwable> problem = judge(input, number);
            if (problem.isPresent()) {
                boolean quick = System.nanoTime() - start < LONGEST_TO_SHRINK.toNanos();
                report(input, number, problem.get(), quick);
            }
        }
        Files.writeString(home.resolve(PROGRESS), Long.toString(number));
    }

    private void report(FuzzCase input, long number, Throwable problem, boolean quick) throws IOException {
        String shape = Failure.shapeOf(problem);
        if (!known.add(shape)) {
            return;
        }
        double seconds = 1e-3 * (System.currentTimeMillis() - started);
        reproducer.write(input, number, shape, problem, seconds);
        System.out.printf("case %d after %.1f s: %s%n", number, seconds, shape);
        if (quick) {
            Throwable[] last = {problem};
            Shrinker shrinker = new Shrinker(
                    smaller -> {
                        Optional<Throwable> again = judge(smaller, number);
                        again.filter(e -> Failure.shapeOf(e).equals(shape)).ifPresent(e -> last[0] = e);
                        return again.map(Failure::shapeOf).filter(shape::equals).isPresent();
                    },
                    System.nanoTime() + SHRINKING.toNanos());
            FuzzCase small = shrinker.shrink(input);
            reproducer.write(small, number, shape, last[0], seconds);
        }
    }

    /** Judges a case; one that does not end also ends this process. */
    private Optional<Throwable> judge(FuzzCase input, long number) {
        Path directory = home.resolve("work");
        try {
            Scratch.delete(directory);
            Files.createDirectories(directory);
            input.writeFiles(directory);
            return watchdog.judge(input, directory);
        } catch (IOException e) {
            return Optional.of(e);
        } catch (Watchdog.Hang hang) {
            try {
                if (known.add(hang.shape())) {
                    double seconds = 1e-3 * (System.currentTimeMillis() - started);
                    reproducer.write(input, number, hang.shape(), hang, seconds);
                    System.out.printf("case %d after %.1f s: %s%n", number, seconds, hang.shape());
                }
            } catch (IOException e) {
                System.out.println("case " + number + ": " + e);
            }
            System.out.flush();
            Runtime.getRuntime().halt(HANGS);
            return Optional.empty();
        }
    }

    /** The time that something has taken, s. */
    static double secondsSince(long nanoTime) {
        return NANO * (System.nanoTime() - nanoTime);
    }
}
