using Rabit.Uav.ImageProcessing;

namespace Rabit.Uav.Tests.ImageProcessing;

public sealed class ColourTargetDetectorContractTests : TargetDetectorContract
{
    public ColourTargetDetectorContractTests()
        : base(new ColourTargetDetector(TargetClass.Defaults))
    {
    }
}
