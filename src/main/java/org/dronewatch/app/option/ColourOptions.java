package org.dronewatch.app.option;

import java.util.OptionalInt;
import org.dronewatch.render.photo.ColourCamera;
import org.dronewatch.setting.InputException;
import picocli.CommandLine.Option;

/** The options of {@code render} for a colour picture as taken by a camera. */
public final class ColourOptions {
    @Option(
            names = "--colour",
            description =
                    "Draws a colour picture as the camera would take it: materials, sun, sky and haze (PNG, MP4 or"
                            + " GIF).")
    private boolean colour;

    @Option(
            names = "--samples",
            paramLabel = "N",
            description = "With --colour, each pixel is the mean of N x N rays, 1 to " + ColourCamera.MOST_SAMPLES
                    + "; " + ColourCamera.SAMPLES + " by default.")
    private Integer samples;

    /**
     * The number of rays along each axis of a pixel in a colour picture; empty for one in shades of blue.
     *
     * @param ofCamera whether the picture is that of a camera
     * @param ending extension of the file's name
     */
    public OptionalInt samples(boolean ofCamera, String ending) {
        if (!colour) {
            if (samples != null) {
                throw new InputException("--samples " + samples + ": has no effect without --colour");
            }
            return OptionalInt.empty();
        }
        if (!ofCamera) {
            throw new InputException("--colour: only for --camera; pictures of the site are in colour anyway");
        }
        if (ending.equals("pfm")) {
            throw new InputException(
                    "--colour: a .pfm file holds distances; name a .png, .mp4 or .gif file with --out");
        }
        return OptionalInt.of(checked("--samples", samples));
    }

    /** A number of samples within its limits; the default for none. */
    static int checked(String option, Integer given) {
        int number = given == null ? ColourCamera.SAMPLES : given;
        if (number < 1 || number > ColourCamera.MOST_SAMPLES) {
            throw new InputException(option + " " + number + ": must be 1 to " + ColourCamera.MOST_SAMPLES);
        }
        return number;
    }
}
