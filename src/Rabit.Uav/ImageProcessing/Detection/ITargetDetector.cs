using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Finds targets in pictures: the part of Image Processing that a user may replace
/// (<see cref="ImageProcessingOptions.Detector"/>). Waiting for poses, geolocation, covariances on the ground and
/// reports are not its matter.
/// </summary>
/// <remarks>
/// <para>
/// Thread: that of the Image Processing manager, one picture at a time. The manager does nothing else meanwhile.
/// </para>
/// <para>
/// Time: <see cref="ImageProcessingOptions.DetectorTimeBudget"/>; a longer call is counted, and its detections are
/// still used.
/// </para>
/// <para>
/// Memory: a detector should allocate nothing for each picture; the span is the manager's, and is used after the call.
/// </para>
/// <para>
/// An exception, or a number of detections that the span cannot hold, makes the picture count as not searched, so that
/// nothing becomes a missed observation for it. A detection that is not valid (not a number, outside the picture, of a
/// class that was not asked for, a score outside 0 to 1, no extent, a covariance that is not positive definite) is left
/// out, and the others are used. Both are counted in <see cref="Messages.ImagingStatus"/> and reported by Health
/// Monitoring; neither ends the run.
/// </para>
/// <para>For the same pictures it should give the same detections: replays and simulated flights depend on it.</para>
/// </remarks>
/// <example>
/// A detector of one's own is given to Image Processing with the classes that it knows:
/// <code>
/// var options = new UavOptions
/// {
///     Imaging = new ImageProcessingOptions
///     {
///         Camera = cameraModel,
///         TargetClasses = [new TargetClass("person") { MinSideMetres = 0.3, MaxSideMetres = 2 }],
///         Detector = new MyDetector(),
///     },
/// };
/// </code>
/// </example>
public interface ITargetDetector
{
    /// <summary>Searches one picture.</summary>
    /// <param name="input">The picture, the classes to search for, and how large pixels are on the ground.</param>
    /// <param name="detections">
    /// Takes what was found, from its start, the most confident first; as long as
    /// <see cref="ImageProcessingOptions.MaxReportsPerPicture"/>. What is in it before the call has no meaning.
    /// </param>
    /// <returns>How many were written, or why the picture could not be searched.</returns>
    DetectorResult Detect(in DetectorInput input, Span<TargetDetection> detections);
}
