/** Many runs of a scene with values drawn by chance, and what may be concluded from them. */
package org.dronewatch.campaign;
