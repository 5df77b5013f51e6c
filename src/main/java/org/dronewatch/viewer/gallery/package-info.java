/** The packaged scenes as cards with pictures, from which the user chooses one. */
package org.dronewatch.viewer.gallery;
