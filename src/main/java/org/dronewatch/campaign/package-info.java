/** Many runs of a scene with values drawn at random, and what can be concluded from them. */
package org.dronewatch.campaign;
