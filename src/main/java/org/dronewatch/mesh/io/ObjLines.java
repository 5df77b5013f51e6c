package org.dronewatch.mesh.io;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.Reader;
import java.util.concurrent.CancellationException;

/**
 * The statements of an OBJ or MTL file: continued lines joined, outer white space and trailing comments of vertices and
 * faces removed. Knows which line was read last, and never holds more than one line of bounded length.
 */
final class ObjLines extends BufferedReader {
    /** The longest line, continued ones joined, in characters. */
    static final int LONGEST_LINE = 1 << 20;

    private static final int CHUNK = 1 << 13;

    /** After this many lines it checks whether its thread has been interrupted. */
    private static final int LINES_BETWEEN_CHECKS = 1000;

    private final char[] chunk = new char[CHUNK];
    private final StringBuilder text = new StringBuilder();
    private int next;
    private int end;
    private boolean afterReturn;
    private int lines;
    private int nextCheck = LINES_BETWEEN_CHECKS;
    private int firstLine;

    ObjLines(Reader reader) {
        super(reader);
    }

    /** Where the statement that was read last begins, as the start of a message: {@code file:line: }. */
    String at(String file) {
        return file + ":" + firstLine + ": ";
    }

    /** The number of the line that was read last, from 1; of a continued one, where it starts. */
    int line() {
        return firstLine;
    }

    /**
     * The next statement, empty for a line without one; null after the last.
     *
     * @throws CancellationException when the thread is interrupted while the file is read
     * @throws IOException also when the line is too long or holds a zero byte
     */
    @Override
    public String readLine() throws IOException {
        text.setLength(0);
        firstLine = lines + 1;
        if (!appendLine()) {
            return null;
        }
        if (lines >= nextCheck) {
            nextCheck = lines + LINES_BETWEEN_CHECKS;
            if (Thread.currentThread().isInterrupted()) {
                throw new CancellationException("interrupted while a model was read");
            }
        }
        boolean numbers = startsLikeNumbers();
        int from = 0;
        while (!(numbers && text.indexOf("#", from) >= 0) && endsWithBackslash()) {
            from = text.length();
            text.setCharAt(from - 1, ' ');
            if (!appendLine()) {
                break;
            }
        }
        return statement(numbers);
    }

    /** Appends what comes before the next end of line; false at the end of the file. */
    private boolean appendLine() throws IOException {
        if (next == end && !fill()) {
            return false;
        }
        lines++;
        boolean ended = false;
        while (!ended && (next < end || fill())) {
            int start = next;
            while (next < end && chunk[next] != '\n' && chunk[next] != '\r') {
                next++;
            }
            text.append(chunk, start, next - start);
            if (text.length() > LONGEST_LINE) {
                throw new IOException("line of more than " + LONGEST_LINE + " characters");
            }
            ended = next < end;
        }
        if (ended) {
            afterReturn = chunk[next++] == '\r';
            skipLineFeed();
        }
        return true;
    }

    /** The line feed of a pair of carriage return and line feed belongs to the line before. */
    private void skipLineFeed() throws IOException {
        if (afterReturn && (next < end || fill()) && chunk[next] == '\n') {
            next++;
        }
        afterReturn = false;
    }

    private boolean fill() throws IOException {
        next = 0;
        end = Math.max(0, read(chunk, 0, CHUNK));
        return end > 0;
    }

    /**
     * Whether the statement is a comment, a vertex or a face: there a comment goes on to the end of its line, and a
     * backslash in it, as at the end of a directory's name, continues nothing. Names, on the other hand, may hold a
     * number sign.
     */
    private boolean startsLikeNumbers() {
        int i = 0;
        while (i < text.length() && Character.isWhitespace(text.charAt(i))) {
            i++;
        }
        return i < text.length() && "vVfF#".indexOf(text.charAt(i)) >= 0;
    }

    private boolean endsWithBackslash() {
        return text.length() > 0 && text.charAt(text.length() - 1) == '\\';
    }

    private String statement(boolean numbers) throws IOException {
        if (text.indexOf("\0") >= 0) {
            throw new IOException("contains a zero byte: not a text file");
        }
        int comment = numbers ? text.indexOf("#") : -1;
        return text.substring(0, comment >= 0 ? comment : text.length()).strip();
    }
}
