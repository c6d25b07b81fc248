using NUnit.Framework;

namespace Glint.Tests
{
    /// <summary>A scene that a test fills, and a new gatherer; both are removed after each test.</summary>
    public abstract class GathererFixture
    {
        internal SceneBuilder _scene;
        internal SceneGatherer _gatherer;

        [SetUp]
        public void MakeScene()
        {
            _scene = new SceneBuilder();
            _gatherer = new SceneGatherer();
        }

        [TearDown]
        public void RemoveScene() => _scene.Destroy();
    }
}
