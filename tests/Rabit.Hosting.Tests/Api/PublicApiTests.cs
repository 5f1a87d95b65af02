using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Hosting.Tests.Api;

/// <summary>
/// The public surface of the package changes only on purpose. To change it: run <c>RABIT_UPDATE_API=1 dotnet test
/// tests/Rabit.Hosting.Tests</c>, and commit PublicApi.txt together with the change.
/// </summary>
public sealed class PublicApiTests
{
    [Fact]
    public void PublicSurface_OfUavHosting_IsThatOfTheFile()
        => PublicApiText.AssertUnchanged(
            typeof(Rabit.Uav.Hosting.RabitUavBuilder).Assembly, "tests/Rabit.Hosting.Tests/Api/PublicApi.Uav.txt");

    [Fact]
    public void PublicSurface_OfTheAssembly_IsThatOfTheFile()
        => PublicApiText.AssertUnchanged(typeof(RabitBuilder).Assembly, "tests/Rabit.Hosting.Tests/Api/PublicApi.txt");
}
