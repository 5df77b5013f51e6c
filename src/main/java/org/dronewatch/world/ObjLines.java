package org.dronewatch.world;

import java.io.IOException;
import java.io.LineNumberReader;
import java.io.Reader;
import java.util.concurrent.CancellationException;

/**
 * Hands out the lines of an OBJ file as its parser likes them: continued lines joined, tabs and trailing comments of
 * vertices and faces removed, and knows where it is. Refuses what the parser would misread without a word.
 */
final class ObjLines extends LineNumberReader {
    private static final int LONGEST_LINE = 1 << 20;
    private static final int LONGEST_INDEX = 9;

    /** After so many lines it looks whether its thread has been interrupted. */
    private static final int LINES_A_LOOK = 1000;

    private int firstLine;

    ObjLines(Reader reader) {
        super(reader);
    }

    /** The place of the line that was read last, as the start of a message: {@code file:line: }. */
    String at(String file) {
        return file + ":" + firstLine + ": ";
    }

    /** The number of the line that was read last, from 1; of a continued one, where it starts. */
    int line() {
        return firstLine;
    }

    @Override
    public String readLine() throws IOException {
        String line = super.readLine();
        firstLine = getLineNumber();
        if (firstLine % LINES_A_LOOK == 0 && Thread.currentThread().isInterrupted()) {
            throw new CancellationException("interrupted while a model was read");
        }
        if (line == null) {
            return null;
        }
        while (line.endsWith("\\")) {
            String next = super.readLine();
            line = line.substring(0, line.length() - 1) + " " + (next == null ? "" : next);
            if (line.length() > LONGEST_LINE) {
                throw new IOException("line of more than " + LONGEST_LINE + " characters");
            }
        }
        return tidy(line);
    }

    private static String tidy(String line) throws IOException {
        if (line.length() > LONGEST_LINE) {
            throw new IOException("line of " + line.length() + " characters; at most " + LONGEST_LINE + " are read");
        }
        String text = line.strip();
        if (text.indexOf('\0') >= 0) {
            throw new IOException("holds a zero byte: not a text file");
        }
        boolean numbers = text.startsWith("v") || text.startsWith("f") || text.startsWith("F");
        if (!numbers) {
            return text;
        }
        int comment = text.indexOf('#');
        text = (comment >= 0 ? text.substring(0, comment) : text).replace('\t', ' ');
        if (text.startsWith("f") || text.startsWith("F")) {
            refuseLongIndices(text);
        }
        return text;
    }

    private static void refuseLongIndices(String face) throws IOException {
        int digits = 0;
        for (int i = 0; i < face.length(); i++) {
            digits = Character.isDigit(face.charAt(i)) ? digits + 1 : 0;
            if (digits > LONGEST_INDEX) {
                throw new IOException("index of more than " + LONGEST_INDEX + " digits");
            }
        }
    }
}
