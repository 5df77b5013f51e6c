package org.dronewatch.sensor.optics;

import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Aimed;
import org.dronewatch.sensor.Imaging;

/** The geometry of a camera of any kind: its position, its aim and its image. */
public interface PictureSettings extends Aimed, Imaging {

    /** The camera's centre of projection, m. */
    Position position();

    /** The aim of the camera's axis. */
    @Override
    Aim aim();

    /**
     * The camera's rotation about its axis, right side down, so that the image rotates counter-clockwise, rad; 0 for a
     * level horizon.
     */
    default double roll() {
        return 0.0;
    }

    /** The position of the camera's axis in the image, and its near and far planes. */
    default Projection projection() {
        return Projection.DEFAULT;
    }

    /** The number of pixels per row. */
    int width();

    /** The number of rows of the image. */
    int height();

    @Override
    default long pixels() {
        return (long) width() * height();
    }

    /** Field of view along {@link #fovAxis}, rad (0.01 to 179 degrees). */
    double fov();

    /** The axis of the image along which the field of view is measured. */
    FieldOfView fovAxis();

    /**
     * Focal length in pixels, the same for both axes: {@code (side/2) / tan(fov/2)}, where {@code side} is the number
     * of pixels along {@link #fovAxis}.
     */
    default double focalLength() {
        double side = fovAxis() == FieldOfView.VERTICAL ? height() : width();
        return 0.5 * side / Math.tan(0.5 * fov());
    }

    /** Diameter of the entrance pupil of the lens, m; empty for a lens without diffraction. */
    default Optional<Double> aperture() {
        return Optional.empty();
    }

    /** Wavelength of the light or thermal radiation that the camera images, m. */
    default double wavelength() {
        return Lens.GREEN;
    }

    /** The camera's lens, with diffraction. */
    default Lens lens() {
        return new Lens(aperture().map(OptionalDouble::of).orElse(OptionalDouble.empty()), wavelength());
    }

    /** Whether the camera's pictures are of visible light, so that they can be shown in colour. */
    default boolean seesColour() {
        return true;
    }
}
