import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import javax.imageio.ImageIO;

/** Says in one line where two pictures, .pfm or .png, first differ from the top on, and in how many pixels. */
final class FirstPixel {
    private static final class Picture {
        final int width;
        final int height;
        final String[] values;

        Picture(int width, int height) {
            this.width = width;
            this.height = height;
            this.values = new String[width * height];
        }
    }

    private FirstPixel() {}

    public static void main(String[] files) throws IOException {
        Picture one = read(files[0]);
        Picture other = read(files[1]);
        System.out.println(difference(one, other));
    }

    private static String difference(Picture one, Picture other) {
        if (one.width != other.width || one.height != other.height) {
            return one.width + " x " + one.height + " pixels | " + other.width + " x " + other.height;
        }
        int first = -1;
        int count = 0;
        for (int i = 0; i < one.values.length; i++) {
            if (!one.values[i].equals(other.values[i])) {
                first = first < 0 ? i : first;
                count++;
            }
        }
        if (first < 0) {
            return "same pixels, other bytes";
        }
        return String.format(
                Locale.ROOT,
                "row %d, column %d: %s | %s; %d of %d pixels differ",
                first / one.width,
                first % one.width,
                one.values[first],
                other.values[first],
                count,
                one.values.length);
    }

    private static Picture read(String file) throws IOException {
        return file.endsWith(".pfm") ? readPfm(Files.readAllBytes(Path.of(file))) : readPng(file);
    }

    private static Picture readPng(String file) throws IOException {
        BufferedImage image = ImageIO.read(new File(file));
        Picture picture = new Picture(image.getWidth(), image.getHeight());
        for (int i = 0; i < picture.values.length; i++) {
            picture.values[i] = String.format("#%08x", image.getRGB(i % picture.width, i / picture.width));
        }
        return picture;
    }

    /** Three lines of text (kind, size, byte order by sign), then rows from the bottom up. */
    private static Picture readPfm(byte[] bytes) {
        int at = 0;
        String[] header = new String[3];
        for (int line = 0; line < 3; line++) {
            int end = at;
            while (bytes[end] != '\n') {
                end++;
            }
            header[line] = new String(bytes, at, end - at, java.nio.charset.StandardCharsets.US_ASCII);
            at = end + 1;
        }
        String[] size = header[1].split(" ");
        Picture picture = new Picture(Integer.parseInt(size[0]), Integer.parseInt(size[1]));
        ByteBuffer values = ByteBuffer.wrap(bytes, at, bytes.length - at)
                .order(header[2].startsWith("-") ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
        for (int row = picture.height - 1; row >= 0; row--) {
            for (int column = 0; column < picture.width; column++) {
                float value = values.getFloat();
                picture.values[row * picture.width + column] =
                        Float.toString(value) + (Float.isNaN(value) ? Integer.toHexString(Float.floatToRawIntBits(value)) : "");
            }
        }
        return picture;
    }
}
