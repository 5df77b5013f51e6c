package org.dronewatch.app;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.dronewatch.app.Program.Outcome;

/**
 * A process that executes one command after the other: for commands that need jars which this process lacks, and not a
 * start of Java each.
 */
final class CommandProcess implements AutoCloseable {
    private final Process process;
    private final DataOutputStream commands;
    private final DataInputStream outcomes;

    private CommandProcess(Process process) {
        this.process = process;
        commands = new DataOutputStream(process.getOutputStream());
        outcomes = new DataInputStream(process.getInputStream());
    }

    /** Starts a process in a directory, where its log will be. */
    static CommandProcess start(Path directory, List<Path> jars, List<String> javaOptions) throws IOException {
        return new CommandProcess(new ProcessBuilder(Program.java(CommandProcess.class, jars, javaOptions))
                .directory(directory.toFile())
                .redirectError(directory.resolve("log.txt").toFile())
                .start());
    }

    /** Executes a command there. */
    Outcome run(String... arguments) throws IOException {
        commands.writeInt(arguments.length);
        for (String argument : arguments) {
            write(commands, argument);
        }
        commands.flush();
        return CompletableFuture.supplyAsync(this::readOutcome)
                .orTimeout(120, TimeUnit.SECONDS)
                .join();
    }

    private Outcome readOutcome() {
        try {
            return new Outcome(outcomes.readInt(), read(outcomes), read(outcomes));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public void close() {
        process.destroyForcibly();
    }

    private static void write(DataOutputStream to, String text) throws IOException {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        to.writeInt(bytes.length);
        to.write(bytes);
    }

    private static String read(DataInputStream from) throws IOException {
        return new String(from.readNBytes(from.readInt()), StandardCharsets.UTF_8);
    }

    /** The other side: executes what arrives until nothing more can. */
    public static void main(String[] none) throws IOException {
        DataInputStream commands = new DataInputStream(System.in);
        DataOutputStream outcomes = new DataOutputStream(System.out);
        System.setOut(System.err);
        while (true) {
            String[] arguments;
            try {
                arguments = new String[commands.readInt()];
            } catch (EOFException e) {
                return;
            }
            for (int i = 0; i < arguments.length; i++) {
                arguments[i] = read(commands);
            }
            Outcome outcome = Program.run(arguments);
            outcomes.writeInt(outcome.code());
            write(outcomes, outcome.out());
            write(outcomes, outcome.err());
            outcomes.flush();
        }
    }
}
