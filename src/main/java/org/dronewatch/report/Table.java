package org.dronewatch.report;

import de.siegmar.fastcsv.writer.CsvWriter;
import de.siegmar.fastcsv.writer.LineDelimiter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** A CSV file that is written row by row; a row is in the file as soon as it is written. */
final class Table implements AutoCloseable {
    private final CsvWriter writer;
    private boolean closed;

    Table(Path file, String... header) throws IOException {
        this.writer = CsvWriter.builder()
                .lineDelimiter(LineDelimiter.LF)
                .autoFlush(true)
                .build(Files.newBufferedWriter(file, StandardCharsets.UTF_8));
        writer.writeRecord(header);
    }

    void row(String... values) {
        writer.writeRecord(values);
    }

    /** Closes the file; twice is no harm. */
    @Override
    public void close() {
        if (closed) {
            return;
        }
        closed = true;
        try {
            writer.close();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
