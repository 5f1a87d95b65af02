namespace Rabit.Uav.Tests.ImageProcessing;

public sealed class RednessDetectorContractTests : TargetDetectorContract
{
    public RednessDetectorContractTests()
        : base(new RednessDetector())
    {
    }
}
