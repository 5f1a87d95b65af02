using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>An upright part of a picture in which a pixel reaches about equally far on the ground.</summary>
internal struct ScalePart
{
    public PlaneScale Scale;
    public double Left;
    public double Top;
    public double Right;
    public double Bottom;
}
