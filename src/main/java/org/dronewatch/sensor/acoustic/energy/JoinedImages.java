package org.dronewatch.sensor.acoustic.energy;

import java.util.function.ToDoubleFunction;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.energy.ScatterSamples.Sample;
import org.dronewatch.sensor.acoustic.energy.ScatterSamples.Samples;
import org.dronewatch.sensor.acoustic.imagesource.ImageSourceCandidates;
import org.dronewatch.sensor.acoustic.imagesource.ImageSources;
import org.dronewatch.sensor.acoustic.imagesource.SpecularPath;
import org.dronewatch.sensor.acoustic.imagesource.WallPlanes;
import org.dronewatch.sound.OctaveBands;

/**
 * Chooses the image sources that join scattered sound to an end: those without which too much would depend on the rays
 * that happen to pass the end. For use by one thread.
 */
final class JoinedImages {
    /** Maximum number of image sources that join scattered sound to an end. */
    private static final int MOST = 64;

    /**
     * Image sources are left to the rays that happen to pass the end if they increase the relative variance of a
     * reading by less than this.
     */
    private static final double NEGLIGIBLE = 3e-4;

    private final WallPlanes planes;
    private final SpecularPath path;
    private final double ofOneRay;

    /**
     * Prepares to choose.
     *
     * @param ofOneRay contribution to a reading of a ray that passes an end, as a fraction of the ray's energy, 1/m2
     */
    JoinedImages(WallPlanes planes, SpecularPath path, double ofOneRay) {
        this.planes = planes;
        this.path = path;
        this.ofOneRay = ofOneRay;
    }

    /**
     * The image sources of an end by whose reflections most of the sound that is scattered at given points reaches this
     * end.
     *
     * @param known the sound heard without them
     * @param first the sound heard from an image source by reflections before any scattering
     */
    ImageSources of(
            ImageSourceCandidates candidates, Position end, Samples near, double known, ToDoubleFunction<int[]> first) {
        ImageSources tried = candidates.best(Integer.MAX_VALUE, 0.0);
        double[] images = new double[3 * tried.count()];
        tried.positions(end.x(), end.y(), end.z(), planes, images);
        ImageSourceCandidates worthy = new ImageSourceCandidates();
        double all = known;
        for (int image = 1; image < tried.count(); image++) {
            double worth = first.applyAsDouble(tried.walls(image));
            for (Sample point : near.points()) {
                if (path.follow(
                        tried,
                        images,
                        image,
                        point.at().x(),
                        point.at().y(),
                        point.at().z(),
                        point.wall(),
                        WallPlanes.NONE)) {
                    worth += heard(point) / near.rays();
                }
            }
            if (worth > 0.0) {
                worthy.add(tried.walls(image), worth);
                all += worth;
            }
        }
        return worthy.best(MOST, NEGLIGIBLE * all * all / ofOneRay);
    }

    private double heard(Sample point) {
        double reflected = 0.0;
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            reflected += path.reflected(band) / OctaveBands.COUNT;
        }
        double cosine = Math.max(0.0, path.cosineAtBeginning(point.normal()));
        return point.energy() * reflected * cosine / (Math.PI * path.length() * path.length());
    }
}
