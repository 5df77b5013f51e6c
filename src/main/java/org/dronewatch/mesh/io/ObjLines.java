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

    // The statement that was read last: part of the chunk, or of what was put together.
    private char[] characters = chunk;
    private char[] together = {};
    private int statementStart;
    private int statementEnd;

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
        return advance() ? new String(characters, statementStart, statementEnd - statementStart) : null;
    }

    /**
     * Reads the next statement like {@link #readLine}, but makes no text of it: its characters are valid until the next
     * one is read.
     *
     * @return false after the last
     */
    boolean advance() throws IOException {
        firstLine = lines + 1;
        skipLineFeed();
        if (next == end && !fill()) {
            return false;
        }
        if (!takeLine()) {
            putTogether();
        }
        if (lines >= nextCheck) {
            nextCheck = lines + LINES_BETWEEN_CHECKS;
            if (Thread.currentThread().isInterrupted()) {
                throw new CancellationException("interrupted while a model was read");
            }
        }
        return true;
    }

    /** The characters among which those of the statement are. */
    char[] characters() {
        return characters;
    }

    /** Where the statement starts among the characters. */
    int start() {
        return statementStart;
    }

    /** Where it ends, exclusive. */
    int end() {
        return statementEnd;
    }

    /** Takes a line as it is; false, and nothing is read, where it is continued, invalid, or goes beyond the chunk. */
    private boolean takeLine() {
        int comment = -1;
        int at = next;
        for (; at < end; at++) {
            char c = chunk[at];
            if (c <= '#') {
                if (c == '\n' || c == '\r' || c == 0) {
                    break;
                }
                comment = c == '#' && comment < 0 ? at : comment;
            }
        }
        if (at == end || chunk[at] == 0 || at > next && chunk[at - 1] == '\\') {
            return false;
        }
        setStatement(chunk, next, at, comment);
        lines++;
        afterReturn = chunk[at] == '\r';
        next = at + 1;
        return true;
    }

    private void setStatement(char[] of, int from, int to, int comment) {
        int start = from;
        while (start < to && isWhite(of[start])) {
            start++;
        }
        int stop = comment >= 0 && "vVfF#".indexOf(of[start]) >= 0 ? comment : to;
        while (stop > start && isWhite(of[stop - 1])) {
            stop--;
        }
        characters = of;
        statementStart = start;
        statementEnd = stop;
    }

    /** As {@link Character#isWhitespace(char)}, without a look into its table for what is usual. */
    static boolean isWhite(char c) {
        return c == ' ' || (c < ' ' || c > '~') && Character.isWhitespace(c);
    }

    /** Puts a statement together from one line or more. */
    private void putTogether() throws IOException {
        text.setLength(0);
        appendLine();
        boolean numbers = startsLikeNumbers();
        int from = 0;
        while (!(numbers && text.indexOf("#", from) >= 0) && endsWithBackslash()) {
            from = text.length();
            text.setCharAt(from - 1, ' ');
            skipLineFeed();
            if (!appendLine()) {
                break;
            }
        }
        if (text.indexOf("\0") >= 0) {
            throw new IOException("contains a zero byte: not a text file");
        }
        if (together.length < text.length()) {
            together = new char[text.length()];
        }
        text.getChars(0, text.length(), together, 0);
        setStatement(together, 0, text.length(), numbers ? text.indexOf("#") : -1);
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
        }
        return true;
    }

    /** The line feed of a pair of carriage return and line feed belongs to the line before, which has been read. */
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
}
