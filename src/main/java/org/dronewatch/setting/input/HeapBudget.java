package org.dronewatch.setting.input;

import org.dronewatch.setting.InputException;

/**
 * The memory that the content of one file may take: half of the heap that Java may use, so that a file that unpacks to
 * more is refused with a one-line message before memory runs out. The caller estimates how much is taken. For use by
 * one thread at a time.
 */
public final class HeapBudget {
    private static final int MEBIBYTE = 1 << 20;

    private final String file;
    private final String advice;
    private final long most;
    private long taken;

    /**
     * The budget of this process.
     *
     * @param file name of the file in messages
     * @param advice what the user can do instead, as the middle of a sentence
     */
    public HeapBudget(String file, String advice) {
        this(file, advice, Runtime.getRuntime().maxMemory());
    }

    /** A budget for a heap of another size, bytes. */
    public HeapBudget(String file, String advice, long heap) {
        this.file = file;
        this.advice = advice;
        this.most = heap / 2;
    }

    /**
     * Reserves memory that stays in use while the file is read.
     *
     * @param bytes number of bytes, 0 or more
     * @throws InputException when this is more than is left
     */
    public void take(long bytes) {
        check(bytes);
        taken += bytes;
    }

    /**
     * Checks whether there is memory for something that is needed only for a short time.
     *
     * @param bytes number of bytes, 0 or more
     * @throws InputException when there is not enough
     */
    public void check(long bytes) {
        if (bytes > most - taken) {
            throw new InputException(file + ": its content takes more than " + most / MEBIBYTE
                    + " MB, half of the memory that Java may use: " + advice
                    + ", or give Java more memory, as in java -Xmx4g");
        }
    }
}
