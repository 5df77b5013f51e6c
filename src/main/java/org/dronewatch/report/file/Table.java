package org.dronewatch.report.file;

import de.siegmar.fastcsv.writer.CsvWriter;
import de.siegmar.fastcsv.writer.LineDelimiter;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/** A CSV file that is written row by row; a row is in the file as soon as it is written. */
public final class Table implements AutoCloseable {
    private final OutputStream stream;
    private final CsvWriter writer;
    private boolean closed;

    /** Creates a file, or replaces an existing one, and writes the header. */
    public Table(Path file, String... header) throws IOException {
        // Not a channel, because an interrupt would close it in the middle of a row.
        this.stream = new FileOutputStream(file.toFile());
        this.writer = CsvWriter.builder()
                .lineDelimiter(LineDelimiter.LF)
                .autoFlush(true)
                .build(new OutputStreamWriter(stream, StandardCharsets.UTF_8));
        try {
            writer.writeRecord(header);
        } catch (RuntimeException e) {
            stream.close();
            throw e;
        }
    }

    /** Writes a row. */
    public void row(String... values) {
        writer.writeRecord(values);
    }

    /** Closes the file; idempotent. */
    @Override
    public void close() {
        if (closed) {
            return;
        }
        closed = true;
        try {
            writer.close();
            // A writer that cannot write what is left does not close its stream.
        } catch (IOException | RuntimeException e) {
            closeStream(e);
            throw e instanceof RuntimeException known ? known : new UncheckedIOException((IOException) e);
        }
    }

    private void closeStream(Exception problem) {
        try {
            stream.close();
        } catch (IOException e) {
            problem.addSuppressed(e);
        }
    }
}
