using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.ImageProcessing;

public sealed class ColourTargetDetectorContractTests : TargetDetectorContract
{
    public ColourTargetDetectorContractTests()
        : base(new ColourTargetDetector(TargetClass.Defaults))
    {
    }
}
