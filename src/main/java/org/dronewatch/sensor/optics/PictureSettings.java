package org.dronewatch.sensor.optics;

import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Aimed;
import org.dronewatch.sensor.Imaging;

/** Where a camera of any kind stands, where it points, and how many pixels its image has. */
public interface PictureSettings extends Aimed, Imaging {

    /** Where its centre of projection is, m. */
    Position position();

    /** Where its axis points. */
    @Override
    Aim aim();

    /**
     * How far it is turned about its axis: its right side down, so that the image turns counterclockwise, rad. At 0 the
     * horizon is level.
     */
    default double roll() {
        return 0.0;
    }

    /** Where its axis meets the image. */
    default Projection projection() {
        return Projection.DEFAULT;
    }

    /** Pixels in a row. */
    int width();

    /** Rows of the image. */
    int height();

    @Override
    default long pixels() {
        return (long) width() * height();
    }

    /** Field of view, 0.01 to 179 degrees, rad. */
    double fov();

    /** The axis of the image along which the field of view is measured. */
    FieldOfView fovAxis();

    /** Focal length in pixels, the same for both axes: {@code (side/2) / tan(fov/2)}. */
    default double focalLength() {
        double side = fovAxis() == FieldOfView.VERTICAL ? height() : width();
        return 0.5 * side / Math.tan(0.5 * fov());
    }

    /** Diameter of the entrance pupil of its lens, m; empty for a lens that does not blur. */
    default Optional<Double> aperture() {
        return Optional.empty();
    }

    /** Wavelength of the light or heat that it sees, m. */
    default double wavelength() {
        return Lens.GREEN;
    }

    /** Its lens, as far as it blurs. */
    default Lens lens() {
        return new Lens(aperture().map(OptionalDouble::of).orElse(OptionalDouble.empty()), wavelength());
    }

    /** Whether its pictures are of visible light, so that they can be shown in colour. */
    default boolean seesColour() {
        return true;
    }
}
